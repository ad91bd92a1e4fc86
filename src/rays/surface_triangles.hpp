#pragma once

#include "src/rays/surface_triangle.hpp"
#include "src/shadow/view/frustum.hpp"

#include <optional>
#include <vector>

namespace edgeshade::rays {

/// All triangles of the scene relative to the frustum's position, with those of its ground if the
/// eye is above it. Where a section cuts the scene, the whole scene's triangles are clipped here,
/// in double, and parts that are cut away cast or are left out, as the section says; its fill comes
/// from the cut scene. `castMasked` as in CasterSettings.
/// `cutoutsCast`: MASK surfaces cast too, where their alpha leaves them.
std::vector<SurfaceTriangle> surfaceTriangles(const Scene& scene, const Frustum& frustum,
                                              bool castMasked, bool cutoutsCast);

/// The same without an eye: triangles are relative to `origin`, in the world, no back is culled,
/// and the ground is among them.
std::vector<SurfaceTriangle> surfaceTriangles(const Scene& scene, const glm::dvec3& origin,
                                              bool castMasked, bool cutoutsCast);

} // namespace edgeshade::rays
