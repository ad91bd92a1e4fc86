#pragma once

#include "src/cli/sunhours_options.hpp"
#include "src/hours/part.hpp"

namespace edgeshade::cli {

/// Writes the picture of a whole run, and counts and report if requested, and prints a line about
/// it. The same part gives the same bytes. Throws Error(output), and InputError if the settings in
/// the part's file are invalid.
void writeSunHours(const hours::Part& whole, const std::string& source, const SunHoursFiles& files);

} // namespace edgeshade::cli
