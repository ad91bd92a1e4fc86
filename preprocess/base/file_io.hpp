#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace edgeshade {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole file of at most `mostBytes`. Throws InputError naming the path if it can't, before
/// it takes memory where a file is larger.
Bytes readFile(const std::filesystem::path& path,
               std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max());

/// Writes `bytes` beside `path` and renames the result over it, so that a reader sees the old
/// file or the new one and nothing in between. SIGINT, SIGTERM, SIGHUP and SIGQUIT wait until that
/// is done. Links are followed; a device or a pipe is written into instead. Throws Error(output)
/// naming the path, and leaves nothing behind, if it can't.
void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The same for text.
void writeFile(const std::filesystem::path& path, std::string_view text);

} // namespace edgeshade
