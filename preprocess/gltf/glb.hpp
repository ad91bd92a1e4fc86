#pragma once

#include "preprocess/base/file_io.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace edgeshade {

/// The two chunks of a GLB container (glTF 2.0, chapter 4).
struct GlbChunks {
    std::string json;
    std::optional<Bytes> binary;
};

/// Whether the bytes start with GLB's magic number.
bool isGlb(std::span<const std::uint8_t> bytes);

/// Splits a GLB into its chunks. Safe on untrusted input. Throws InputError naming `path`.
GlbChunks splitGlb(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Builds a GLB, with JSON padded to four bytes by spaces and binary data by zeros. Throws
/// Error(output) beyond the 4 GiB that the container can hold.
Bytes joinGlb(std::string json, Bytes binary);

} // namespace edgeshade
