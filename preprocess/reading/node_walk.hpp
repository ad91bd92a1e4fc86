#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// One node that carries a mesh, as met when walking the scene from its roots.
struct MeshNode {
    int node = -1;
    int animatedNode = -1;       ///< nearest animated node on the way to the root; -1: static
    glm::dmat4 animatedFromNode; ///< relative to the animated node; to the world if there is none
};

/// What walking the default scene finds.
struct NodeWalk {
    std::vector<MeshNode> meshNodes;         ///< depth first, in the file's order
    std::vector<AnimatedNode> animatedNodes; ///< what moves by itself, those above first
    std::vector<glm::dmat4> worldFromNode;   ///< of every node of the scene; identity elsewhere
};

/// Walks the default scene (the first if none is named; all roots if there are no scenes), from
/// where CESIUM_RTC puts it; meshes that KHR_node_visibility hides are left out. Throws
/// InputError for a missing node, a node reached twice or too deep, or a transform that is not
/// finite.
NodeWalk walkNodes(const GltfDocument& document, Warnings& warnings);

} // namespace edgeshade
