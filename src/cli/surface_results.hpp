#pragma once

#include "src/cli/report.hpp"
#include "src/cli/sunhours_options.hpp"
#include "src/hours/surfaces/surface_part.hpp"

namespace edgeshade::cli {

/// Whether a file needs every bit.
bool keepsBits(const SunHoursFiles& files);

/// Throws Error(usage) if one of the files would exceed what bits may take.
void requireBitsFit(const SunHoursFiles& files, std::size_t cells, std::size_t positions);

/// Writes the files and the report of a whole run over surfaces, ends the bar, and prints a line
/// about the run. The same run gives the same bytes. `source`: the file that settings are from, for
/// messages; `when`: tables have the first and last time. Throws Error(output), and InputError for
/// invalid settings.
void writeSurfaces(const hours::SurfacePart& whole, const std::string& source,
                   const SunHoursFiles& files, bool when, ProgressBar& bar);

} // namespace edgeshade::cli
