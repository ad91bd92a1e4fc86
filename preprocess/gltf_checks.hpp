#pragma once

#include "preprocess/limits.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace edgeshade {

/// Parses JSON that is nested so little that recursive code can walk it, whose objects have so few
/// members that they can be searched one by one, and that takes no more than there is in `memory`.
/// Throws InputError.
nlohmann::ordered_json parseJson(std::string_view text, const std::filesystem::path& path,
                                 MemoryBudget& memory);

/// Checks a glTF asset's JSON before any typed code sees it: its version, the extensions that it
/// requires, and the kind and range of every field that this program or tinygltf reads. tinygltf
/// takes an optional field of the wrong kind for a missing one, and a negative offset for 0.
/// Throws an InputError that names the field and its value.
///
/// What numbers refer to is checked here where it is a buffer, a view or a sampler, and in
/// animations; the rest where it is used.
void requireSoundGltf(const nlohmann::ordered_json& json, const std::filesystem::path& path);

/// Refuses a sound asset of too many nodes, or whose sections would take too much once they are
/// typed. Throws InputError.
void requireWithinLimits(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                         MemoryBudget& memory);

} // namespace edgeshade
