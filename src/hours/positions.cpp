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

std::vector<std::uint8_t> monthsOf(std::span<const Position> positions,
                                   std::chrono::minutes offset) {
    using namespace std::chrono;
    std::vector<std::uint8_t> months;
    for (const Position& position : positions) {
        const year_month_day day(floor<days>(position.time + offset));
        months.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(day.month()) - 1));
    }
    return months;
}

} // namespace edgeshade::hours
