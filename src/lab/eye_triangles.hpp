#pragma once

#include "src/lab/eye_triangle.hpp"
#include "src/shadow/view/frustum.hpp"

#include <vector>

namespace edgeshade::lab {

/// All triangles of the scene relative to the frustum's position, with those of its ground if the
/// eye is above it. Where a section cuts the scene, the whole scene's triangles are clipped here,
/// in double, and parts that are cut away cast or are left out, as the section says; its fill comes
/// from the cut scene. `cutoutsCast` as in Question, `castMasked` as in CasterSettings.
std::vector<EyeTriangle> eyeTriangles(const Scene& scene, const Frustum& frustum, bool castMasked,
                                      bool cutoutsCast);

} // namespace edgeshade::lab
