#include "src/hours/positions.hpp"

#include "src/sun/day.hpp"
#include "src/sun/direction.hpp"

namespace edgeshade::hours {

std::vector<Position> positionsBetween(const sun::Place& place, sun::Instant from, sun::Instant to,
                                       std::chrono::minutes step, double minAltitude,
                                       double north) {
    std::vector<Position> positions;
    const std::chrono::seconds half = std::chrono::seconds(step) / 2;
    for (const auto& [time, sun] : sun::positionsBetween(place, from + half, to, step))
        if (sun.altitude > minAltitude)
            positions.push_back({time, sun.azimuth, sun.altitude, sun::towardsSun(sun, north)});
    return positions;
}

} // namespace edgeshade::hours
