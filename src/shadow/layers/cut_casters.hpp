#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Casters only, each wholly on one side of a plane, except for rounding.
struct CutCasters {
    Scene scene; ///< the same batches, with only casting triangles and their pieces
    std::vector<std::uint32_t> from; ///< for each triangle, the index of its original caster, over
                                     ///< all batches
    std::vector<bool> inside;        ///< for each triangle, whether dot(plane, (p, 1)) >= 0 on it
};

/// Cuts the casting triangles of a scene by a plane in the world. Pieces keep their triangle's
/// winding and order, and share the points at which edges are cut. Closed casters therefore stay
/// closed along the cut. An edge gives the same float point from either triangle. `castMasked` as
/// in CasterSettings.
CutCasters cutCasters(const Scene& scene, bool castMasked, const glm::dvec4& plane);

} // namespace edgeshade
