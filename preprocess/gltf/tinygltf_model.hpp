#pragma once

#include "preprocess/gltf/animation_checks.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace edgeshade {

/// tinygltf's typed view of the fields that this program reads in sound glTF JSON; it has no
/// others, and no names. Its buffers and images stay empty, and animations in `brokenAnimations`
/// are left out. tinygltf refuses some assets that glTF allows: it parses a copy with placeholders,
/// and these are removed from the result. Throws InputError naming `path`.
tinygltf::Model typedModel(const nlohmann::ordered_json& json,
                           const BrokenAnimations& brokenAnimations,
                           const std::filesystem::path& path);

} // namespace edgeshade
