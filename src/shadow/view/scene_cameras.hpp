#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/view/frustum.hpp"

#include <string>

namespace edgeshade {

/// The first camera of that name, otherwise the first whose node has it, otherwise the one with
/// that index; null if there is none.
const SceneCamera* findCamera(const std::vector<SceneCamera>& cameras,
                              const std::string& nameOrIndex);

/// The camera's name, or its node's, or else its index.
std::string titleOf(const std::vector<SceneCamera>& cameras, std::size_t index);

/// The camera's frustum in a picture with this aspect (width over height); it keeps the camera's
/// height.
Frustum frustumOf(const SceneCamera& camera, double aspect);

/// A perspective camera for orbiting, upright, at the same position and with the same direction. It
/// looks at the part of the box nearest to the middle of its picture.
Camera uprightCamera(const SceneCamera& camera, const Box& bounds);

/// A camera that a viewer can start from.
struct FileCamera {
    std::string title; ///< see titleOf()
    Camera camera;     ///< see uprightCamera()
};

/// The scene's cameras that are in perspective.
std::vector<FileCamera> fileCameras(const Scene& scene);

} // namespace edgeshade
