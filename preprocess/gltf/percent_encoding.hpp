#pragma once

#include <string>
#include <string_view>

namespace edgeshade {

/// Undoes %XX (RFC 3986, 2.1); other characters stay, a % before no two hexadecimal digits too.
std::string percentDecoded(std::string_view text);

} // namespace edgeshade
