#pragma once

#include "src/sun/ephemeris.hpp"

#include <chrono>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade::hours {

/// One interval in which the sun is up.
struct Position {
    sun::Instant time{};                  ///< its middle
    double azimuth = 0.0, altitude = 0.0; ///< degrees, see sun::SunPosition
    glm::dvec3 direction{0.0};            ///< towards the sun in the scene, of length 1
};

/// Divides `from` to `to` into intervals of one step, and returns those in whose middle the sun is
/// above `minAltitude` (degrees, refracted), in order of time. `step`: at least a minute; `north`:
/// as for sun::towardsSun().
std::vector<Position> positionsBetween(const sun::Place& place, sun::Instant from, sun::Instant to,
                                       std::chrono::minutes step, double minAltitude, double north);

/// The month of each position, 0 to 11, on a clock that is `offset` from universal time.
std::vector<std::uint8_t> monthsOf(std::span<const Position> positions,
                                   std::chrono::minutes offset);

/// The bytes of a row of bits, one for each position.
inline std::size_t bytesOfRow(std::size_t positions) {
    return (positions + 7) / 8;
}

} // namespace edgeshade::hours
