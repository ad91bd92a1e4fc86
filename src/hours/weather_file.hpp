#pragma once

#include "src/sun/local_time.hpp"
#include "src/sun/place.hpp"

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace edgeshade::hours {

/// A station's year of direct sunlight from an EnergyPlus weather file (EPW).
struct Weather {
    std::string station; ///< city and country
    sun::Place place;
    std::chrono::minutes offset{0}; ///< of its clock, standard time all year
    /// Energy of the direct beam on a surface that faces the sun, by hour from 1 January, 0:00, on
    /// that clock, in Wh/m²; 8760 hours, or 8784 with 29 February.
    std::vector<double> directNormal;
    std::size_t missing = 0; ///< hours whose value the file lacks; they count as 0

    /// The hour of the year that holds an instant, whatever the year. 29 February is the 28th if
    /// the file has none.
    std::size_t hourOf(sun::Instant instant) const;
};

/// Reads a weather file (EnergyPlus, Auxiliary Programs, EPW data dictionary). Safe on untrusted
/// input. Throws InputError naming file, line and value: anything but a year of hours in order.
Weather readWeather(const std::filesystem::path& path,
                    std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max());

} // namespace edgeshade::hours
