#pragma once

#include "preprocess/scene/animation.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {

/// Applies a pose to the scene, and to the records of deforming batches; see place().
std::vector<Placed> placeScene(LoadedScene& loaded, const Pose& pose);

/// Applies the pose of one of the file's animations at a time, in seconds. `animation`: its name or
/// its index; empty for the first one, with a warning if there are others. Returns null, and
/// changes nothing, if there is no such animation; a missing name gets a warning.
std::optional<std::vector<Placed>> placeAt(LoadedScene& loaded, double seconds,
                                           const std::string& animation = {});

/// Poses the scene for a still picture: batches that vanish lose their triangles. Call it once,
/// after addShadows() and before addGround().
///
/// Returns whether there is such an animation.
bool poseScene(LoadedScene& loaded, double seconds, const std::string& animation = {});

/// Removes the triangles of hidden batches, for a picture of the scene at rest; poseScene() does so
/// itself.
void leaveOutHidden(LoadedScene& loaded);

/// Makes animated batches static, except for deforming ones: in a still picture nothing moves, and
/// all of it may be in primitive maps.
void holdStill(Scene& scene);

} // namespace edgeshade
