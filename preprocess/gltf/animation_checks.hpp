#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

namespace edgeshade {

/// Looks through the animations, which a scene can do without. What is broken of them gets a
/// warning that names the field and its value. What keyframes hold is for readAnimation(). `json`
/// is sound otherwise. Returns the indices of the broken ones.
std::set<std::size_t> findBrokenAnimations(const nlohmann::ordered_json& json,
                                           const std::filesystem::path& path, Warnings& warnings);

} // namespace edgeshade
