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
/// Names by index; none occurs twice.
std::map<std::uint32_t, std::string> namesFrom(const JsonField& field);

/// The place of a part in its run.
struct PartNumber {
    std::size_t number = 1, of = 1, positionsOfRun = 0;
};

/// "part", "parts" and "positions_of_run" of a file's root.
PartNumber partNumberFrom(const JsonField& root);

/// "positions" of a file's root: those of the part. `offset`: of the settings' clock.
std::vector<Position> partPositionsFrom(const JsonField& root, const PartNumber& part,
                                        std::chrono::minutes offset);

/// The JSON of a part's file, of at most 2 GiB.
nlohmann::ordered_json partJsonFrom(const std::filesystem::path& path);

} // namespace edgeshade::hours
