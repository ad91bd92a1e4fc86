#include "src/hours/beam.hpp"

#include "preprocess/base/error.hpp"

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

constexpr minutes hour{60};

/// The number of positions at which the sun is up in the weather's hour that holds `position`.
int positionsUp(const Weather& weather, const Position& position, seconds step) {
    const auto local = position.time + weather.offset;
    const seconds within = local.time_since_epoch() % hour;
    const sun::Instant begin = position.time - within;
    int up = 0;
    for (sun::Instant time = begin + within % step; time < begin + hour; time += step)
        up += sun::sunPosition(weather.place, time).isUp();
    return up;
}

} // namespace

std::vector<double> beamOf(const Weather& weather, std::span<const Position> positions,
                           minutes step) {
    if (hour % step != minutes(0))
        throw Error(ExitStatus::usage, "--step: " + std::to_string(step.count()) +
                                           " does not divide an hour, but weather is by the hour.");
    const double positionsOfHour = 60.0 / static_cast<double>(step.count());
    std::vector<double> beam;
    std::size_t last = weather.directNormal.size();
    sys_days lastDay{};
    int up = 1;
    for (const Position& position : positions) {
        const std::size_t number = weather.hourOf(position.time);
        const sys_days day = floor<days>(position.time);
        if (number != last || day != lastDay) up = positionsUp(weather, position, step);
        last = number;
        lastDay = day;
        beam.push_back(weather.directNormal[number] * positionsOfHour / up);
    }
    return beam;
}

} // namespace edgeshade::hours
