#pragma once

#include "src/hours/part.hpp"
#include "src/hours/settings.hpp"

namespace edgeshade::hours {

/// The report of a whole run, which is part 1 of 1. `settings`: the run's.
nlohmann::ordered_json reportOf(const Part& whole, const HoursSettings& settings);

/// Hours that all positions of the run together stand for.
double possibleHours(const Part& whole, const HoursSettings& settings);

/// The threshold summed over all days; null if there is none.
std::optional<double> totalThreshold(const HoursSettings& settings);

} // namespace edgeshade::hours
