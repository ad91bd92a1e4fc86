#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Whether a node mirrors its contents, at any time.
struct Handedness {
    int scaledNode = -1;   ///< the nearest node, itself or above, whose scale is animated; -1: none
    bool mirrored = false; ///< the transforms below that node mirror, or all if there is none
    bool atRest = false;   ///< all transforms mirror at rest
};

/// A node of the scene, in the walk from its roots.
struct PlacedNode {
    int node = -1;
    NodePlace place;
    bool visible = true; ///< KHR_node_visibility hides neither it nor a node above it
    Handedness hand;
};

/// Result of walking the default scene.
struct NodeWalk {
    std::vector<PlacedNode> nodes;           ///< depth first, in the file's order
    std::vector<AnimatedNode> animatedNodes; ///< nodes that animations move, parents first
    std::vector<glm::dmat4> worldFromNode;   ///< for every node of the scene; identity elsewhere
    std::vector<glm::dmat4> unflattened;     ///< worldFromNode as if no node scaled by 0
};

/// Walks the default scene (the first if none is named; all roots if there are no scenes), from its
/// origin by CESIUM_RTC. Throws InputError for a missing node, a node reached twice or too deep, or
/// a transform that is not finite.
NodeWalk walkNodes(const GltfDocument& document);

} // namespace edgeshade
