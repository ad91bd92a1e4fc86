#pragma once

#include <string>
#include <string_view>

namespace edgeshade {

/// The text as XML and HTML show it, between tags or in a quoted attribute.
std::string escapedForMarkup(std::string_view text);

} // namespace edgeshade
