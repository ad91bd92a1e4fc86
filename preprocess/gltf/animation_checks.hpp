#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace edgeshade {

/// What of the animations can't be read, by index.
struct BrokenAnimations {
    std::set<std::size_t> whole;
    std::set<std::pair<std::size_t, std::size_t>> channels; ///< of others: (animation, channel)
};

/// Looks through the animations, which a scene can do without, and through what the channels of
/// each refer to, which the others can do without. What is broken of them gets a warning that names
/// the field and its value. What keyframes hold is for readAnimation(). `json` is sound otherwise.
BrokenAnimations findBrokenAnimations(const nlohmann::ordered_json& json,
                                      const std::filesystem::path& path, Warnings& warnings);

} // namespace edgeshade
