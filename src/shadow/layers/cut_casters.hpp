#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Casters alone, each wholly on one side of a plane, but for rounding.
struct CutCasters {
    Scene scene;                     ///< batches as before, with casting triangles and their pieces
    std::vector<std::uint32_t> from; ///< the caster that each triangle was, over all batches
    std::vector<bool> inside;        ///< whether it is where dot(plane, (p, 1)) >= 0
};

/// Cuts the casting triangles of a scene by a plane in the world. Pieces keep their triangle's
/// winding and order, and share the points at which edges are cut: what is closed stays closed, cut
/// along the plane. Edges give the same float point from either of their triangles. `castMasked` as
/// in CasterSettings.
CutCasters cutCasters(const Scene& scene, bool castMasked, const glm::dvec4& plane);

} // namespace edgeshade
