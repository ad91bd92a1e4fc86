#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "src/hours/part.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::hours {

// Pieces of part files that pictures and surfaces share. Readers are safe on untrusted input,
// and throw InputError naming file, field and value.

/// Bytes as a data URI of a zlib stream; without bytes "data:,". Throws Error(unavailable) for more
/// than 2^30.
std::string packedBytes(std::span<const std::uint8_t> bytes);
/// Reads packedBytes() of `size` bytes, at most 2^30.
Bytes unpackedBytes(const JsonField& field, const std::filesystem::path& path, std::size_t size);

static_assert(std::endian::native == std::endian::little); // as files are

/// An array of numbers as packedBytes(), little-endian.
template <class T>
std::string packed(std::span<const T> values) {
    return packedBytes({reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
}
/// Reads packed() arrays of `count` elements.
template <class T>
std::vector<T> unpacked(const JsonField& field, const std::filesystem::path& path,
                        std::size_t count) {
    const Bytes bytes = unpackedBytes(field, path, sizeof(T) * count);
    std::vector<T> values(count);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::uint8_t*>(values.data()));
    return values;
}

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
