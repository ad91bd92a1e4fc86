#pragma once

#include "src/shadow/view/frustum.hpp"
#include "src/shadow/view/scene_tree.hpp"
#include "src/shadow/view/visible_part.hpp"

namespace edgeshade {

/// Bounds of all surfaces within the frustum, which is widened slightly. Exact except for rounding:
/// triangles are clipped to it, and omitted if the scene certainly culls them. The same, bit for
/// bit, as if every triangle were clipped (docs/method.md, C26), in a time that depends on the
/// surfaces at the borders of what is visible, and little on the others. `tree`: the scene's;
/// `ground`: the ground counts.
VisiblePart visiblePart(const Scene& scene, const SceneTree& tree, const Frustum& frustum,
                        bool ground);

/// The least depth of one batch's surfaces within that frustum; infinite if it has none there.
double nearestDepth(const Scene& scene, const SceneTree& tree, std::size_t batch,
                    const Frustum& frustum);

/// Whether the picture's eye, which may be at infinity, is above the ground: otherwise the ground
/// is invisible.
bool isAboveGround(const Frustum& frustum, const Batch& ground);

} // namespace edgeshade
