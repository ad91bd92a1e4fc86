#pragma once

#include "src/cli/sunhours_options.hpp"

namespace edgeshade::cli {

/// `sunhours --surfaces`: measures all chosen surfaces and writes the requested files. Throws Error
/// as verbs do.
void sunHoursOfSurfaces(const SunHoursOptions& options);

} // namespace edgeshade::cli
