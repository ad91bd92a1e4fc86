#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace edgeshade {

/// Unreadable animations and channels, by index.
struct BrokenAnimations {
    std::set<std::size_t> whole;
    std::set<std::pair<std::size_t, std::size_t>> channels; ///< (animation, channel), in other
                                                            ///< animations
};

/// Checks the animations, and for each of them the objects that its channels refer to. A scene can
/// do without an animation, and an animation without a channel. Each broken one gets a warning that
/// names the field and its value. readAnimation() checks the keyframes. All else in `json` is
/// sound.
BrokenAnimations findBrokenAnimations(const nlohmann::ordered_json& json,
                                      const std::filesystem::path& path, Warnings& warnings);

} // namespace edgeshade
