#pragma once

#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace edgeshade {

/// Puts right what exporters write that glTF does not allow and that has one meaning all the same:
/// whole numbers spelt as 96.0 or 9.6e1, a byteStride of 0 for none; names that are no text are
/// taken away, with a warning. `json` need not be sound; what else is wrong with it stays.
void mendGltf(nlohmann::ordered_json& json, const std::filesystem::path& path, Warnings& warnings);

} // namespace edgeshade
