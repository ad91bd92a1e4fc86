#pragma once

#include "src/hours/part.hpp"
#include "src/hours/settings.hpp"

namespace edgeshade::hours {

/// The report of a whole run, a part 1 of 1. `settings`: its own.
nlohmann::ordered_json reportOf(const Part& whole, const HoursSettings& settings);

/// Hours that all positions of the run stand for.
double possibleHours(const Part& whole, const HoursSettings& settings);

/// The threshold over all days; nothing where there is none.
std::optional<double> totalThreshold(const HoursSettings& settings);

} // namespace edgeshade::hours
