#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// What tells whether a node mirrors what it places, at whatever time.
struct Handedness {
    int scaledNode = -1;   ///< the nearest above it, or itself, that an animation scales; -1: none
    bool mirrored = false; ///< those below that one do, or all do where there is none
    bool atRest = false;   ///< all of them do at rest
};

/// A node of the scene, as met when walking it from its roots.
struct PlacedNode {
    int node = -1;
    NodePlace place;
    bool visible = true; ///< KHR_node_visibility hides neither it nor one above it
    Handedness hand;
};

/// What walking the default scene finds.
struct NodeWalk {
    std::vector<PlacedNode> nodes;           ///< depth first, in the file's order
    std::vector<AnimatedNode> animatedNodes; ///< what moves by itself, those above first
    std::vector<glm::dmat4> worldFromNode;   ///< of every node of the scene; identity elsewhere
    std::vector<glm::dmat4> unflattened;     ///< the same as if no node scaled by 0
};

/// Walks the default scene (the first if none is named; all roots if there are no scenes), from
/// where CESIUM_RTC puts it. Throws InputError for a missing node, a node reached twice or too
/// deep, or a transform that is not finite.
NodeWalk walkNodes(const GltfDocument& document);

} // namespace edgeshade
