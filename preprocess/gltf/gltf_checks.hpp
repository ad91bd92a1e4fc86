#pragma once

#include "preprocess/base/limits.hpp"
#include "preprocess/base/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace edgeshade {

/// Parses JSON that is nested so little that recursive code can walk it, whose objects have so few
/// members that they can be searched one by one, and that takes no more than there is in `memory`.
/// Bytes that are no UTF-8 are replaced by U+FFFD, with a warning. `inGlb`: it is a GLB's chunk,
/// not a file. Throws InputError.
nlohmann::ordered_json parseJson(std::string_view text, const std::filesystem::path& path,
                                 bool inGlb, MemoryBudget& memory, Warnings& warnings);

/// Checks a glTF asset's JSON before any typed code sees it: its version, the extensions that it
/// requires, and the kind and range of every field that this program or tinygltf reads. tinygltf
/// takes an optional field of the wrong kind for a missing one, and a negative offset for 0.
/// Throws an InputError that names the field and its value.
///
/// What numbers refer to is checked here where it is a buffer, a view, an accessor or a sampler;
/// the rest where it is used. What a scene can do without is for those who read it. Warns of
/// extensions that are required and not drawn.
void requireSoundGltf(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                      Warnings& warnings);

/// Refuses a sound asset of too many nodes, or whose sections would take too much once they are
/// typed. Throws InputError.
void requireWithinLimits(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                         MemoryBudget& memory);

} // namespace edgeshade
