#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace edgeshade {

/// Where bytes begin that are no UTF-8 (RFC 3629); null where all are.
std::optional<std::size_t> firstInvalidUtf8(std::string_view text);

/// The text with U+FFFD, the replacement character, for every byte that is no part of a character.
std::string withValidUtf8(std::string_view text);

} // namespace edgeshade
