#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace edgeshade {

/// Index of the first byte that isn't UTF-8 (RFC 3629); null if all are.
std::optional<std::size_t> firstInvalidUtf8(std::string_view text);

/// The text with U+FFFD, the replacement character, for every byte that belongs to no character.
std::string withValidUtf8(std::string_view text);

} // namespace edgeshade
