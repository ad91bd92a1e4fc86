#pragma once

#include "src/shadow/geometry/light_view.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// The casting triangles that may lie on one of a light's faces.
struct FaceOutlines {
    std::vector<Outline> outlines;
    std::vector<std::uint32_t> triangles; ///< of each outline, counted as forEachCaster() does
};

/// One entry a face of `from`. Most triangles lie on one face, which is what makes it quick.
/// Triangles out of the light's range are on none.
std::vector<FaceOutlines> outlinesByFace(const Scene& scene, bool castMasked,
                                         const LightView& from);

} // namespace edgeshade
