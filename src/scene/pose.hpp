#pragma once

#include "preprocess/scene/animation.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {

/// Puts the scene's parts where the file's animation has them at a time, in seconds; see place().
/// Returns the pose; null where there is no animation, and all stays as it is.
std::optional<Pose> placeAt(LoadedScene& loaded, double seconds);

/// Places batches, cameras and lights as the file's animation has them at a time, in seconds; see
/// poseAt(). Batches that there is nothing of then are left without triangles. To be called once,
/// after addShadows() and before addGround(). A scene without an animation stays as it is.
///
/// Returns whether it has one.
bool poseScene(LoadedScene& loaded, double seconds);

} // namespace edgeshade
