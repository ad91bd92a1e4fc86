#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/reading/node_walk.hpp"

namespace edgeshade {

/// What of the scene's nodes a picture can do without, cameras and lights, is read by these.

/// The text in "name"; empty if there is none.
std::string nameOf(const JsonField& object);

/// A number's value. Throws InputError if it is not between the two.
double numberIn(const JsonField& number, double least, double most);

/// Where the node is that `reference` belongs to. Throws InputError that names the reference if
/// that is farther away than farthestPlace.
glm::dvec3 placeOf(const JsonField& reference, const glm::dmat4& worldFromNode);

/// How it is turned and moved, without scale and mirroring. Throws InputError if it has no turn,
/// too. `unflattened`: the same as if no node scaled by 0.
glm::dmat4 rigidPlaceOf(const JsonField& reference, const glm::dmat4& worldFromNode,
                        const glm::dmat4& unflattened);

/// Calls read(JsonField node, const PlacedNode*) for all nodes: those of the scene in the walk's
/// order, then the others, with null. What it refuses gets a warning that `thing` is left out.
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
