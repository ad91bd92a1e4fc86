#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace edgeshade {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole file of at most `mostBytes`. Throws InputError naming the path on failure; for a
/// larger file, before it allocates memory.
Bytes readFile(const std::filesystem::path& path,
               std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max());

/// Writes `bytes` beside `path` and renames the result over it, so that a reader sees either the
/// old file or the new one. SIGINT, SIGTERM, SIGHUP and SIGQUIT are held until it is done. Links
/// are followed; a device or a pipe is written into. On failure throws Error(output) naming the
/// path, and leaves nothing behind.
void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// As above for text.
void writeFile(const std::filesystem::path& path, std::string_view text);

} // namespace edgeshade
