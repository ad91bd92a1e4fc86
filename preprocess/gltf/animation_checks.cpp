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

/// Extensions may target objects other than nodes, and other properties of nodes.
void checkAnimationTarget(const JsonField& target, std::size_t nodeCount) {
    target.ifPresent("path", [](const JsonField& path) { path.text(); });
    const auto node = target.find("node");
    if (!node) return;
    node->indexInto(nodeCount, "nodes");
    const JsonField path = target.member("path");
    if (!target.find("extensions")) path.oneOf({"translation", "rotation", "scale", "weights"});
}

/// `animation`: the channel's animation.
void checkChannel(const JsonField& channel, const JsonField& animation, std::size_t nodeCount,
                  std::size_t accessorCount) {
    const int sampler =
        channel.member("sampler").indexInto(animation.countOf("samplers"), "samplers");
    checkAnimationSampler(animation.member("samplers").item(static_cast<std::size_t>(sampler)),
                          accessorCount);
    channel.ifPresent("target",
                      [&](const JsonField& target) { checkAnimationTarget(target, nodeCount); });
}

} // namespace

BrokenAnimations findBrokenAnimations(const nlohmann::ordered_json& json,
                                      const std::filesystem::path& path, Warnings& warnings) {
    const JsonField root(path, json);
    const std::size_t nodeCount = root.countOf("nodes"), accessorCount = root.countOf("accessors");
    BrokenAnimations broken;
    std::size_t index = 0;
    const auto checkAnimation = [&](const JsonField& animation) {
        const std::size_t at = index++;
        animation.ifPresent("samplers", [](const JsonField& all) { all.requireArray(); });
        const auto channels = animation.find("channels");
        if (!channels) return;
        std::size_t number = 0;
        channels->forEachItem([&](const JsonField& channel) {
            const auto check = [&] { checkChannel(channel, animation, nodeCount, accessorCount); };
            if (!readOrWarn(warnings, "the channel is left out", check))
                broken.channels.insert({at, number});
            ++number;
        });
    };
    forEachSoundItem(root, "animations", "animation", warnings, checkAnimation,
                     [&](std::size_t at) { broken.whole.insert(at); });
    return broken;
}

} // namespace edgeshade
