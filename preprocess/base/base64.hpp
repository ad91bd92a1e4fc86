#pragma once

#include "preprocess/base/file_io.hpp"

#include <span>
#include <string>

namespace edgeshade {

/// Base64 text of the bytes (RFC 4648, section 4), padded.
std::string base64(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
