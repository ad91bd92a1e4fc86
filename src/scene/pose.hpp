#pragma once

#include "preprocess/scene/animation.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {

/// Puts the scene's parts where a pose has them, and the records of what deforms with it; see
/// place().
std::vector<Placed> placeScene(LoadedScene& loaded, const Pose& pose);

/// The same as an animation of the file has them at a time, in seconds. `animation`: its name or
/// its index, or nothing for the first one, with a warning where there are others. Null where there
/// is none, and all stays as it is; one that was asked for by name is warned of.
std::optional<std::vector<Placed>> placeAt(LoadedScene& loaded, double seconds,
                                           const std::string& animation = {});

/// The same for a picture: what there is nothing of then is left without triangles. To be called
/// once, after addShadows() and before addGround().
///
/// Returns whether there is such an animation.
bool poseScene(LoadedScene& loaded, double seconds, const std::string& animation = {});

/// Leaves what is hidden without triangles, for a picture of the scene at rest; poseScene() does.
void leaveOutHidden(LoadedScene& loaded);

/// What an animation could move, but for what deforms, stands where it is from now on: in a still
/// nothing moves, and all of it may be in primitive maps.
void holdStill(Scene& scene);

} // namespace edgeshade
