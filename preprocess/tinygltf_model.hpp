#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace edgeshade {

/// tinygltf's typed view of sound glTF JSON. Its buffers and images stay empty. tinygltf refuses
/// some assets that glTF allows; it gets a copy with stand-ins there, and no trace of them is left
/// in what is returned. Throws InputError naming `path`.
tinygltf::Model typedModel(const nlohmann::ordered_json& json, const std::filesystem::path& path);

} // namespace edgeshade
