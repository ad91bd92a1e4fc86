#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

namespace edgeshade {

/// What a scene is drawn without.
struct BrokenParts {
    std::set<std::size_t> animations; ///< their indices
};

/// Looks through what a scene can do without: animations, cameras and lights
/// (KHR_lights_punctual). What is broken of it gets a warning that names the field and its value.
/// What keyframes hold is for readAnimation(). `json` is sound otherwise.
BrokenParts findBrokenParts(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                            Warnings& warnings);

} // namespace edgeshade
