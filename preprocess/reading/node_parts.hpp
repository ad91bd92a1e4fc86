#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/reading/node_walk.hpp"

namespace edgeshade {

/// Helpers to read cameras and lights of nodes, which a picture can do without.

/// The text of the member "name"; empty if it is missing.
std::string nameOf(const JsonField& object);

/// A number's value. Throws InputError unless it is between `least` and `most`.
double numberIn(const JsonField& number, double least, double most);

/// The position of the node that `reference` belongs to. Throws InputError naming the reference if
/// it is beyond farthestPlace.
glm::dvec3 placeOf(const JsonField& reference, const glm::dmat4& worldFromNode);

/// The node's rotation and translation, without scale and mirroring. Throws InputError, also if it
/// has no rotation. `unflattened`: `worldFromNode` as if no node scaled by 0.
glm::dmat4 rigidPlaceOf(const JsonField& reference, const glm::dmat4& worldFromNode,
                        const glm::dmat4& unflattened);

/// Calls read(JsonField node, const PlacedNode*) for all nodes: the scene's in the walk's order,
/// then the others with null. If it throws InputError, a warning says that `thing` is left out.
template <class Read>
void forEachNode(const GltfDocument& document, const NodeWalk& walk, const char* thing,
                 Warnings& warnings, Read read) {
    const JsonField root(document.path, document.json);
    const auto nodes = root.find("nodes");
    if (!nodes) return;
    const std::string outcome = std::string("the ") + thing + " is left out";
    std::vector<bool> placed(nodes->size(), false);
    for (const PlacedNode& node : walk.nodes) {
        const auto index = static_cast<std::size_t>(node.node);
        placed[index] = true;
        readOrWarn(warnings, outcome, [&] { read(nodes->item(index), &node); });
    }
    const PlacedNode* const nowhere = nullptr;
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (!placed[i]) readOrWarn(warnings, outcome, [&] { read(nodes->item(i), nowhere); });
}

} // namespace edgeshade
