#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace edgeshade {

/// Repairs invalid glTF of exporters where the meaning is clear: whole numbers written as 96.0 or
/// 9.6e1, and a byteStride of 0 for none. Names that aren't text are removed, with a warning.
/// `json` need not be sound; other errors in it stay.
void mendGltf(nlohmann::ordered_json& json, const std::filesystem::path& path, Warnings& warnings);

} // namespace edgeshade
