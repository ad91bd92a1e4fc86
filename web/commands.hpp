#pragma once

#include "src/viewer/viewer.hpp"

#include <string_view>

namespace edgeshade::web {

/// The command with this name, "orbitLeft" and so on. Throws Error(usage) for other names.
viewer::Command commandOf(std::string_view name);

} // namespace edgeshade::web
