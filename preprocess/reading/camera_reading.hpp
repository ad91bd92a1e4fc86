#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/reading/node_walk.hpp"
#include "preprocess/scene/scene_camera.hpp"

namespace edgeshade {

/// The cameras that the scene's nodes place, in the order of the walk. Broken cameras, and broken
/// nodes that refer to them, are left out with a warning. Hidden nodes place cameras too
/// (KHR_node_visibility). Safe on untrusted input.
std::vector<SceneCamera> readCameras(const GltfDocument& document, const NodeWalk& walk,
                                     Warnings& warnings);

} // namespace edgeshade
