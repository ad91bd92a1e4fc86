#pragma once

#include "src/hours/schedule.hpp"

#include <span>
#include <utility>
#include <vector>

namespace edgeshade::hours {

/// Start and end of an interval.
using Interval = std::pair<sun::Instant, sun::Instant>;

/// The intervals that lit positions stand for, `step` each; those that touch within one day of the
/// clock are joined. `times`: of all positions, in order; `lit`: one per position.
std::vector<Interval> litIntervals(std::span<const sun::Instant> times,
                                   const std::vector<bool>& lit, std::chrono::minutes step,
                                   std::chrono::minutes offset);

} // namespace edgeshade::hours
