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

/// Whether the bytes start like a GLB.
bool isGlb(std::span<const std::uint8_t> bytes);

/// Takes a GLB apart. Safe on untrusted input. Throws InputError naming `path`.
GlbChunks splitGlb(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

/// Puts a GLB together; chunks are padded to four bytes with spaces and zeros. Throws
/// Error(output) if it would pass the 4 GiB that the container can hold.
Bytes joinGlb(std::string json, Bytes binary);

} // namespace edgeshade
