#pragma once

#include "preprocess/gltf/json_field.hpp"
#include "src/hours/part.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::hours {

// Pieces of part files that pictures and surfaces share. Readers are safe on untrusted input,
// and throw InputError naming file, field and value.

/// An array as a data URI of a zlib stream, little-endian; without elements "data:,". T: an
/// unsigned integer, float or double. Throws Error(unavailable) for more than 2^30 bytes.
template <class T>
std::string packed(std::span<const T> values);

/// Reads packed() arrays of `count` elements, at most 2^30 bytes.
template <class T>
std::vector<T> unpacked(const JsonField& field, const std::filesystem::path& path,
                        std::size_t count);

nlohmann::ordered_json vectorJson(const glm::dvec3& vector);
/// A vector of finite numbers.
glm::dvec3 finiteVector(const JsonField& field);

/// [{"index", "name"}].
nlohmann::ordered_json namesJson(const std::map<std::uint32_t, std::string>& names);

/// "part", "parts" and "positions_of_run" of a file's root.
PartNumber partNumberFrom(const JsonField& root);

/// The head of a file's root: "settings", "scene", "warnings", "positions", those of the part, and
/// names, of which no index occurs twice. The offset is that of the settings' clock.
RunHead runHeadFrom(const JsonField& root, const PartNumber& part);

/// The JSON of a part's file, of at most 2 GiB.
nlohmann::ordered_json partJsonFrom(const std::filesystem::path& path);

} // namespace edgeshade::hours
