#pragma once

#include "preprocess/gltf/animation_checks.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace edgeshade {

/// tinygltf's typed view of what this program reads of sound glTF JSON; all else, names too, is
/// left out of it. Its buffers and images stay empty; of animations it has what is not among
/// `brokenAnimations`. tinygltf refuses some assets that glTF allows; it gets a copy with stand-ins
/// there, and no trace of them is left in what is returned. Throws InputError naming `path`.
tinygltf::Model typedModel(const nlohmann::ordered_json& json,
                           const BrokenAnimations& brokenAnimations,
                           const std::filesystem::path& path);

} // namespace edgeshade
