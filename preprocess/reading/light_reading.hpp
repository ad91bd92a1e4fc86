#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/reading/node_walk.hpp"
#include "preprocess/scene/scene_light.hpp"

namespace edgeshade {

/// The lights that the scene's nodes place (KHR_lights_punctual), in the order of the walk. Hidden
/// nodes place none (KHR_node_visibility). Broken lights, and broken nodes that refer to them, are
/// left out with a warning. Safe on untrusted input.
std::vector<SceneLight> readLights(const GltfDocument& document, const NodeWalk& walk,
                                   Warnings& warnings);

} // namespace edgeshade
