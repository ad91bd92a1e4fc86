#pragma once

#include "src/sun/ephemeris.hpp"

#include <chrono>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::hours {

/// One interval in which the sun is up.
struct Position {
    sun::Instant time{};                  ///< its middle
    double azimuth = 0.0, altitude = 0.0; ///< degrees, see sun::SunPosition
    glm::dvec3 direction{0.0};            ///< towards the sun in the scene, of length 1
};

/// Of the intervals of one step from `from` to `to` those in whose middle the sun is above an
/// altitude (degrees, refracted), in order of time. `step`: at least a minute; `north`: as
/// sun::towardsSun() has it.
std::vector<Position> positionsBetween(const sun::Place& place, sun::Instant from, sun::Instant to,
                                       std::chrono::minutes step, double minAltitude, double north);

} // namespace edgeshade::hours
