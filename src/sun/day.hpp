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

/// An altitude for the sun's centre to cross.
struct Horizon {
    double altitude = 0.0; ///< degrees
    bool airless = false;  ///< compares SunPosition::airlessAltitude, not the refracted altitude
};

/// The horizon of direct light: SunPosition::isUp().
inline constexpr Horizon lightHorizon{};
/// The horizon of almanacs' sunrise and sunset: upper limb 16' above the centre, refraction 34'.
inline constexpr Horizon almanacHorizon{-50.0 / 60.0, true};

struct Crossing {
    Instant time{}; ///< the first second after the crossing
    bool rising = false;
};

/// The sun's crossings of the horizon between `from` and `to`, in order, to the second. Empty if it
/// is always up (polar day) or down (polar night). Days of less than ten minutes are found too, if
/// the sun is above for more than a second or two.
std::vector<Crossing> crossings(const Place& place, Instant from, Instant to,
                                const Horizon& horizon = lightHorizon);

/// The arcs along which the sun is up between `from` and `to`. Each starts where it rises, or at
/// `from`, and ends where it sets, or at `to`, with points at whole multiples of `step` from `from`
/// in between. Empty in the polar night; two arcs where midnight lies within a day of light.
std::vector<std::vector<TimedPosition>> sunPaths(const Place& place, Instant from, Instant to,
                                                 std::chrono::seconds step);

} // namespace edgeshade::sun
