#pragma once

#include <string>
#include <string_view>

namespace edgeshade {

/// Decodes %XX (RFC 3986, 2.1). Other characters stay, and so does a % without two hexadecimal
/// digits after it.
std::string percentDecoded(std::string_view text);

} // namespace edgeshade
