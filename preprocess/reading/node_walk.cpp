#include "preprocess/reading/node_walk.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/reading/rest_transform.hpp"
#include "preprocess/scene/node_transform.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

namespace edgeshade {
namespace {

bool isFinite(const glm::dmat4& matrix) {
    for (glm::length_t c = 0; c < 4; ++c)
        for (glm::length_t r = 0; r < 4; ++r)
            if (!std::isfinite(matrix[c][r])) return false;
    return true;
}

std::set<int> animatedNodes(const GltfDocument& document) {
    std::set<int> nodes;
    for (const auto& animation : document.model->animations)
        for (const auto& channel : animation.channels)
            if (channel.target_path != "weights") nodes.insert(channel.target_node);
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

/// Without scenes every node is below a root, unless it is its own ancestor.
void requireAllReached(const GltfDocument& document, const std::vector<bool>& reached) {
    if (!document.model->scenes.empty()) return;
    const auto missed = std::find(reached.begin(), reached.end(), false);
    if (missed != reached.end())
        throw InputError(document.where("nodes[") + std::to_string(missed - reached.begin()) +
                         "] is its own ancestor or below such a node; the nodes must be a tree.");
}

/// Where CESIUM_RTC puts the origin of the asset.
glm::dvec3 centerOf(const GltfDocument& document) {
    glm::dvec3 center(0.0);
    JsonField(document.path, document.json)
        .ifExtension("CESIUM_RTC", [&](const JsonField& extension) {
            const std::vector<double> numbers = extension.member("center").numbers(3);
            center = {numbers[0], numbers[1], numbers[2]};
        });
    return center;
}

/// Whether KHR_node_visibility leaves the node in the scene, and with it what is below it.
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

struct Visit {
    int node;
    int animatedNode;
    bool visible;        ///< all nodes above it are
    std::uint64_t depth; ///< 1: a root
    glm::dmat4 animatedFromParent;
    glm::dmat4 worldFromParent;
};

} // namespace

NodeWalk walkNodes(const GltfDocument& document, Warnings& warnings) {
    const auto& nodes = document.model->nodes;
    const std::set<int> animated = animatedNodes(document);
    NodeWalk walk;
    walk.worldFromNode.assign(nodes.size(), glm::dmat4(1.0));
    std::vector<bool> reached(nodes.size(), false);
    std::vector<Visit> open;
    const auto openAll = [&open](const std::vector<int>& children, int animatedNode, bool visible,
                                 std::uint64_t depth, const glm::dmat4& animatedFrom,
                                 const glm::dmat4& worldFrom) {
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            open.push_back({*child, animatedNode, visible, depth, animatedFrom, worldFrom});
    };
    const std::uint64_t deepest = document.memory.limits().nodeDepth;
    const glm::dmat4 worldFromAsset = glm::translate(glm::dmat4(1.0), centerOf(document));
    openAll(rootNodes(document), -1, true, 1, worldFromAsset, worldFromAsset);
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const std::string field = "nodes[" + std::to_string(visit.node) + "]";
        if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= nodes.size())
            throw InputError(document.where(field) + " is referred to, but there are " +
                             std::to_string(nodes.size()) + " nodes.");
        if (reached[visit.node])
            throw InputError(document.where(field) +
                             " is reached twice; the nodes must be a tree.");
        if (visit.depth > deepest)
            throw InputError(document.where(field) + " lies on level " +
                             std::to_string(visit.depth) + " of the nodes, but the limit is " +
                             std::to_string(deepest) + ".");
        reached[visit.node] = true;

        const tinygltf::Node& node = nodes[visit.node];
        const glm::dmat4 local = restMatrix(node);
        const glm::dmat4 worldFromNode = visit.worldFromParent * local;
        if (!isFinite(worldFromNode))
            throw InputError(document.where(field) + " has a transform that is not finite.");
        walk.worldFromNode[visit.node] = worldFromNode;

        int animatedNode = visit.animatedNode;
        glm::dmat4 animatedFromNode = visit.animatedFromParent * local;
        if (animated.contains(visit.node)) {
            if (glm::determinant(glm::dmat3(worldFromNode)) != 0.0) {
                walk.animatedNodes.push_back(
                    {visit.node, visit.animatedNode, visit.animatedFromParent, local});
                animatedNode = visit.node;
                animatedFromNode = glm::dmat4(1.0);
            } else {
                warnings.add("An animated node that is scaled to nothing at rest stays static.");
            }
        }
        const bool visible = visit.visible && isVisible(document, visit.node);
        walk.nodes.push_back({visit.node, {animatedNode, animatedFromNode}, visible});
        openAll(node.children, animatedNode, visible, visit.depth + 1, animatedFromNode,
                worldFromNode);
    }
    requireAllReached(document, reached);
    return walk;
}

} // namespace edgeshade
