#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A node of the scene, as met when walking it from its roots.
struct PlacedNode {
    int node = -1;
    NodePlace place;
    bool visible = true; ///< KHR_node_visibility hides neither it nor one above it
};

/// What walking the default scene finds.
struct NodeWalk {
    std::vector<PlacedNode> nodes;           ///< depth first, in the file's order
    std::vector<AnimatedNode> animatedNodes; ///< what moves by itself, those above first
    std::vector<glm::dmat4> worldFromNode;   ///< of every node of the scene; identity elsewhere
};

/// Walks the default scene (the first if none is named; all roots if there are no scenes), from
/// where CESIUM_RTC puts it. Throws InputError for a missing node, a node reached twice or too
/// deep, or a transform that is not finite.
NodeWalk walkNodes(const GltfDocument& document, Warnings& warnings);

} // namespace edgeshade
