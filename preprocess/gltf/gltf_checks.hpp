#pragma once

#include "preprocess/base/limits.hpp"
#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace edgeshade {

/// Parses JSON within limits: its nesting is safe for recursive code, its objects are small enough
/// to search linearly, and it fits `memory`. Bytes that aren't UTF-8 are replaced by U+FFFD, with a
/// warning. `inGlb`: it is a GLB's chunk, not a file. Throws InputError.
nlohmann::ordered_json parseJson(std::string_view text, const std::filesystem::path& path,
                                 bool inGlb, MemoryBudget& memory, Warnings& warnings);

/// Checks a glTF asset's JSON before any typed code reads it: its version, its required extensions,
/// and the type and range of every field that this program or tinygltf reads. tinygltf takes an
/// optional field of the wrong type for a missing one, and a negative offset for 0. Throws an
/// InputError that names the field and its value.
///
/// References to buffers, views, accessors and samplers are checked here, all others where they are
/// used. Optional parts of a scene are checked by the code that reads them. Warns of required
/// extensions that aren't drawn.
void requireSoundGltf(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                      Warnings& warnings);

/// Refuses a sound asset with too many nodes, or whose sections would take too much memory as typed
/// data. Throws InputError.
void requireWithinLimits(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                         MemoryBudget& memory);

} // namespace edgeshade
