#pragma once

#include "src/sun/ephemeris.hpp"

#include <chrono>
#include <vector>

namespace edgeshade::sun {

struct TimedPosition {
    Instant time{};
    SunPosition position;
};

/// Positions at `from`, `from + step`, ... before `to`. `step`: above 0.
std::vector<TimedPosition> positionsBetween(const Place& place, Instant from, Instant to,
                                            std::chrono::seconds step);

/// An altitude that the sun's centre is to cross.
struct Horizon {
    double altitude = 0.0; ///< degrees
    bool airless = false;  ///< of SunPosition::airlessAltitude, not of the refracted altitude
};

/// Where light ends: SunPosition::isUp().
inline constexpr Horizon lightHorizon{};
/// Almanacs' sunrise and sunset: the upper limb, 16' above the centre, on a horizon where
/// refraction is 34'.
inline constexpr Horizon almanacHorizon{-50.0 / 60.0, true};

struct Crossing {
    Instant time{}; ///< the first second after it
    bool rising = false;
};

/// When the sun crosses the horizon between `from` and `to`, in order, to the second. None where it
/// is up all the time (polar day) or down (polar night). A rise of less than ten minutes is found
/// too, where the sun is above for more than a second or two.
std::vector<Crossing> crossings(const Place& place, Instant from, Instant to,
                                const Horizon& horizon = lightHorizon);

/// The arcs along which the sun is up between `from` and `to`, each from where it rises, or `from`,
/// to where it sets, or `to`, with points at whole multiples of `step` from `from` in between.
/// None in the polar night; two where midnight lies within a day of light.
std::vector<std::vector<TimedPosition>> sunPaths(const Place& place, Instant from, Instant to,
                                                 std::chrono::seconds step);

} // namespace edgeshade::sun
