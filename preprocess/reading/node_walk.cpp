#include "preprocess/reading/node_walk.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/reading/rest_transform.hpp"
#include "preprocess/scene/node_transform.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

namespace edgeshade {
namespace {

/// Nodes of animated paths that count: isOne(path).
template <class IsOne>
std::set<int> animatedNodes(const GltfDocument& document, const IsOne& isOne) {
    std::set<int> nodes;
    for (const auto& animation : document.model->animations)
        for (const auto& channel : animation.channels)
            if (isOne(channel.target_path)) nodes.insert(channel.target_node);
    return nodes;
}

std::vector<int> rootNodes(const GltfDocument& document) {
    const tinygltf::Model& model = *document.model;
    if (!model.scenes.empty()) {
        const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
        if (static_cast<std::size_t>(scene) >= model.scenes.size())
            throw InputError(document.where("scene") + " is " + std::to_string(scene) +
                             ", but there are " + std::to_string(model.scenes.size()) + " scenes.");
        return model.scenes[scene].nodes;
    }
    std::set<int> children;
    for (const auto& node : model.nodes)
        children.insert(node.children.begin(), node.children.end());
    std::vector<int> roots;
    for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i)
        if (!children.contains(i)) roots.push_back(i);
    return roots;
}

/// In an asset without scenes every node is below a root, unless it is its own ancestor.
void requireAllReached(const GltfDocument& document, const std::vector<bool>& reached) {
    if (!document.model->scenes.empty()) return;
    const auto missed = std::find(reached.begin(), reached.end(), false);
    if (missed != reached.end())
        throw InputError(document.where("nodes[") + std::to_string(missed - reached.begin()) +
                         "] is its own ancestor or below such a node; the nodes must be a tree.");
}

/// The asset's origin by CESIUM_RTC.
glm::dvec3 centerOf(const GltfDocument& document) {
    glm::dvec3 center(0.0);
    JsonField(document.path, document.json)
        .ifExtension("CESIUM_RTC", [&](const JsonField& extension) {
            const std::vector<double> numbers = extension.member("center").numbers(3);
            center = {numbers[0], numbers[1], numbers[2]};
        });
    return center;
}

/// Whether KHR_node_visibility shows the node, and the nodes below it.
bool isVisible(const GltfDocument& document, int node) {
    const auto& source = document.json.at("nodes").at(static_cast<std::size_t>(node));
    bool visible = true;
    JsonField(document.path, source)
        .ifExtension("KHR_node_visibility", [&](const JsonField& extension) {
            extension.ifPresent("visible",
                                [&](const JsonField& flag) { visible = flag.boolean(); });
        });
    return visible;
}

/// The parent's state, as seen by its children.
struct Hanging {
    NodePlace place;
    glm::dmat4 worldFromParent{1.0};
    glm::dmat4 worldFromParentUnflattened{1.0};
    Handedness hand;
    bool visible = true;     ///< all nodes above are visible
    std::uint64_t depth = 0; ///< of the parent; a root has 1
};

struct Visit {
    int node;
    Hanging from; ///< from the parent
};

/// The scale by 0 of a matrix with zero columns: multiplying makes the unflattened matrix flat
/// again.
glm::dmat4 flatteningOf(const glm::dmat4& local) {
    glm::dmat4 flattening(1.0);
    for (glm::length_t c = 0; c < 3; ++c)
        if (glm::dvec3(local[c]) == glm::dvec3(0.0)) flattening[c][c] = 0.0;
    return flattening;
}

/// The handedness below a node, from the one above it.
Handedness handOf(Handedness above, int node, const glm::dmat4& local, bool scaled) {
    const double sign = glm::determinant(glm::dmat3(local));
    const auto with = [sign](bool mirrored) { return sign != 0.0 && mirrored != (sign < 0.0); };
    above.atRest = with(above.atRest);
    if (scaled)
        above = {node, false, above.atRest};
    else
        above.mirrored = with(above.mirrored);
    return above;
}

} // namespace

NodeWalk walkNodes(const GltfDocument& document) {
    const auto& nodes = document.model->nodes;
    const auto animated =
        animatedNodes(document, [](const std::string& path) { return path != "weights"; });
    const auto scaled = // and with their scale their handedness
        animatedNodes(document, [](const std::string& path) { return path == "scale"; });
    NodeWalk walk;
    walk.worldFromNode.assign(nodes.size(), glm::dmat4(1.0));
    walk.unflattened = walk.worldFromNode;
    std::vector<bool> reached(nodes.size(), false);
    std::vector<Visit> open;
    const auto openAll = [&open](const std::vector<int>& children, const Hanging& from) {
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            open.push_back({*child, from});
    };
    const std::uint64_t deepest = document.memory.limits().nodeDepth;
    const glm::dmat4 worldFromAsset = glm::translate(glm::dmat4(1.0), centerOf(document));
    openAll(rootNodes(document),
            {{-1, worldFromAsset, worldFromAsset}, worldFromAsset, worldFromAsset, {}, true, 0});
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const Hanging& from = visit.from;
        const std::string field = "nodes[" + std::to_string(visit.node) + "]";
        if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= nodes.size())
            throw InputError(document.where(field) + " is referenced, but there are " +
                             std::to_string(nodes.size()) + " nodes.");
        if (reached[visit.node])
            throw InputError(document.where(field) +
                             " is reached twice; the nodes must be a tree.");
        const std::uint64_t depth = from.depth + 1;
        if (depth > deepest)
            throw InputError(document.where(field) + " lies on level " + std::to_string(depth) +
                             " of the node tree, but the limit is " + std::to_string(deepest) +
                             ".");
        reached[visit.node] = true;

        const tinygltf::Node& node = nodes[visit.node];
        const glm::dmat4 local = restMatrix(node), unflattened = unflattenedRestMatrix(node);
        const glm::dmat4 worldFromNode = from.worldFromParent * local;
        if (!isFinite(worldFromNode))
            throw InputError(document.where(field) + " has a transform that is not finite.");
        walk.worldFromNode[visit.node] = worldFromNode;

        walk.unflattened[visit.node] = from.worldFromParentUnflattened * unflattened;

        NodePlace place{from.place.animatedNode, from.place.animatedFromNode * local,
                        from.place.unflattened * unflattened};
        if (animated.contains(visit.node)) {
            // A node that no animation scales is always flat: its flattened triangles are moved.
            const bool flat = local != unflattened && !scaled.contains(visit.node);
            walk.animatedNodes.push_back({visit.node, from.place.animatedNode,
                                          from.place.animatedFromNode, flat ? unflattened : local,
                                          from.place.unflattened, unflattened});
            place = {visit.node, flat ? flatteningOf(local) : glm::dmat4(1.0), glm::dmat4(1.0)};
        }
        const bool visible = from.visible && isVisible(document, visit.node);
        const Handedness hand = handOf(from.hand, visit.node, local, scaled.contains(visit.node));
        walk.nodes.push_back({visit.node, place, visible, hand});
        openAll(node.children,
                {place, worldFromNode, walk.unflattened[visit.node], hand, visible, depth});
    }
    requireAllReached(document, reached);
    return walk;
}

} // namespace edgeshade
