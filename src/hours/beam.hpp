#pragma once

#include "src/hours/positions.hpp"
#include "src/hours/weather_file.hpp"

#include <span>

namespace edgeshade::hours {

/// The mean irradiance of the direct beam at each position, on a surface that faces the sun, in
/// W/m². An hour's energy is shared by the positions of that hour at which the sun is up, also
/// those that clock hours or a least altitude leave out. So all positions of an hour together have
/// its energy, at sunrise too. An hour in which the sun is up at no position gives nothing.
///
/// `step`: minutes that a position stands for, which divide an hour. Throws Error(usage) naming
/// --step if they don't.
std::vector<double> beamOf(const Weather& weather, std::span<const Position> positions,
                           std::chrono::minutes step);

} // namespace edgeshade::hours
