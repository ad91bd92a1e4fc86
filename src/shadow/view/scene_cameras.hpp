#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/view/frustum.hpp"

#include <string>

namespace edgeshade {

/// The first camera of that name, the first whose node has it, or else the one of that index; null
/// where there is none.
const SceneCamera* findCamera(const std::vector<SceneCamera>& cameras,
                              const std::string& nameOrIndex);

/// The camera's name, or its node's, or else its index.
std::string titleOf(const std::vector<SceneCamera>& cameras, std::size_t index);

/// What the camera sees in a picture with this aspect (width over height): as much of height as it
/// says.
Frustum frustumOf(const SceneCamera& camera, double aspect);

/// A perspective camera in the same place that looks the same way, upright, at what of the box is
/// nearest to the middle of its picture: to orbit from there.
Camera uprightCamera(const SceneCamera& camera, const Box& bounds);

/// A camera that a viewer can show, and go on from.
struct FileCamera {
    std::string title; ///< see titleOf()
    Camera camera;     ///< see uprightCamera()
};

/// The scene's cameras that are in perspective.
std::vector<FileCamera> fileCameras(const Scene& scene);

} // namespace edgeshade
