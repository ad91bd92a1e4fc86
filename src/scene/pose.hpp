#pragma once

#include "src/scene/load.hpp"

namespace edgeshade {

/// Places batches, cameras and lights as the file's animation has them at a time, in seconds; see
/// poseAt(). Batches that there is nothing of then are left without triangles. To be called once,
/// after addShadows() and before addGround(). A scene without an animation stays as it is.
///
/// Returns whether it has one.
bool poseScene(LoadedScene& loaded, double seconds);

} // namespace edgeshade
