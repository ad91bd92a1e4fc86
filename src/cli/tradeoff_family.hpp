#pragma once

#include "src/cli/draw_settings.hpp"

#include <string>
#include <vector>

namespace edgeshade::cli {

/// The kind of shadows of a setting, in words of people: "volumes", "maps, vsm", "cascades".
std::string familyOf(const DrawSettings& settings);

/// These families and those that are always there, each once, in an order that doesn't change as
/// settings come and go.
std::vector<std::string> allFamilies(const std::vector<std::string>& families);

} // namespace edgeshade::cli
