#include "preprocess/gltf/animation_checks.hpp"

#include "preprocess/gltf/optional_items.hpp"

namespace edgeshade {
namespace {

void checkAnimationSampler(const JsonField& sampler, std::size_t accessorCount) {
    sampler.member("input").indexInto(accessorCount, "accessors");
    sampler.member("output").indexInto(accessorCount, "accessors");
    sampler.ifPresent("interpolation", [](const JsonField& interpolation) {
        interpolation.oneOf({"STEP", "LINEAR", "CUBICSPLINE"});
    });
}

/// Extensions may move things that are no nodes, and nodes in ways of their own.
void checkAnimationTarget(const JsonField& target, std::size_t nodeCount) {
    target.ifPresent("path", [](const JsonField& path) { path.text(); });
    const auto node = target.find("node");
    if (!node) return;
    node->indexInto(nodeCount, "nodes");
    const JsonField path = target.member("path");
    if (!target.find("extensions")) path.oneOf({"translation", "rotation", "scale", "weights"});
}

void checkAnimation(const JsonField& animation, std::size_t nodeCount, std::size_t accessorCount) {
    const std::size_t samplerCount = animation.countOf("samplers");
    animation.ifPresent("samplers", [&](const JsonField& samplers) {
        samplers.forEachItem(
            [&](const JsonField& sampler) { checkAnimationSampler(sampler, accessorCount); });
    });
    animation.ifPresent("channels", [&](const JsonField& channels) {
        channels.forEachItem([&](const JsonField& channel) {
            channel.member("sampler").indexInto(samplerCount, "samplers");
            channel.ifPresent("target", [&](const JsonField& target) {
                checkAnimationTarget(target, nodeCount);
            });
        });
    });
}

} // namespace

std::set<std::size_t> findBrokenAnimations(const nlohmann::ordered_json& json,
                                           const std::filesystem::path& path, Warnings& warnings) {
    const JsonField root(path, json);
    const std::size_t nodeCount = root.countOf("nodes"), accessorCount = root.countOf("accessors");
    std::set<std::size_t> broken;
    forEachSoundItem(
        root, "animations", "animation", warnings,
        [&](const JsonField& animation) { checkAnimation(animation, nodeCount, accessorCount); },
        [&](std::size_t index) { broken.insert(index); });
    return broken;
}

} // namespace edgeshade
