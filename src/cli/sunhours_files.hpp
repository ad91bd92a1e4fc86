#pragma once

#include "src/cli/sunhours_options.hpp"
#include "src/hours/part.hpp"

namespace edgeshade::cli {

/// Writes the picture, and counts and report where they are asked for, of a whole run, and prints
/// a line on it. The same part, the same bytes. Throws Error(output), and InputError where the
/// part's settings, which a file had, are broken.
void writeSunHours(const hours::Part& whole, const std::string& source, const SunHoursFiles& files);

} // namespace edgeshade::cli
