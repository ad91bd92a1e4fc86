#include "src/sun/day.hpp"

#include <algorithm>

namespace edgeshade::sun {
namespace {

using std::chrono::seconds;

/// The sun's height above the horizon as a function of time.
struct Height {
    const Place& place;
    const Horizon& horizon;

    double operator()(Instant time) const {
        const SunPosition at = sunPosition(place, time);
        return (horizon.airless ? at.airlessAltitude : at.altitude) - horizon.altitude;
    }
};

/// The first second from which the sun is on its side of the horizon at `to`, not that at `from`.
Instant changeBetween(const Height& height, Instant from, Instant to) {
    const bool after = height(to) > 0.0;
    while (to - from > seconds(1)) {
        const Instant middle = from + (to - from) / 2;
        ((height(middle) > 0.0) == after ? to : from) = middle;
    }
    return to;
}

/// The time of the highest (`sign` 1) or lowest (-1) point between the two, if there is a single
/// one.
Instant turnBetween(const Height& height, Instant from, Instant to, double sign) {
    while (to - from > seconds(2)) {
        const Instant middle = from + (to - from) / 2;
        const double slope = height(middle + seconds(1)) - height(middle);
        (slope * sign > 0.0 ? from : to) = middle;
    }
    return from + (to - from) / 2;
}

} // namespace

std::vector<TimedPosition> positionsBetween(const Place& place, Instant from, Instant to,
                                            seconds step) {
    std::vector<TimedPosition> positions;
    for (Instant time = from; time < to; time += step)
        positions.push_back({time, sunPosition(place, time)});
    return positions;
}

std::vector<Crossing> crossings(const Place& place, Instant from, Instant to,
                                const Horizon& horizon) {
    const Height height{place, horizon};
    std::vector<Crossing> found;
    const auto search = [&](Instant start, Instant end) {
        const bool rising = height(end) > 0.0;
        if (rising != (height(start) > 0.0))
            found.push_back({changeBetween(height, start, end), rising});
    };

    // Between two samples on one side of the horizon the sun may briefly be on the other.
    const seconds step = std::chrono::minutes(10);
    for (Instant start = from; start < to; start += step) {
        const Instant end = std::min(start + step, to);
        const double first = height(start), last = height(end);
        const double sign = first > 0.0 ? -1.0 : 1.0;
        const bool turns = (first > 0.0) == (last > 0.0) &&
                           (height(start + seconds(1)) - first) * sign > 0.0 &&
                           (last - height(end - seconds(1))) * sign < 0.0;
        if (turns) {
            const Instant turn = turnBetween(height, start, end, sign);
            search(start, turn);
            search(turn, end);
        } else {
            search(start, end);
        }
    }
    return found;
}

std::vector<std::vector<TimedPosition>> sunPaths(const Place& place, Instant from, Instant to,
                                                 seconds step) {
    const auto at = [&](Instant time) { return TimedPosition{time, sunPosition(place, time)}; };
    std::vector<Crossing> changes = crossings(place, from, to);
    if (at(from).position.isUp()) changes.insert(changes.begin(), {from, true});

    std::vector<std::vector<TimedPosition>> paths;
    for (std::size_t i = 0; i < changes.size(); i += 2) { // rises and sets alternate
        const Instant rise = changes[i].time;
        const Instant set = i + 1 < changes.size() ? changes[i + 1].time : to;
        std::vector<TimedPosition> path{at(rise)};
        for (Instant time = from + ((rise - from) / step + 1) * step; time < set; time += step)
            path.push_back(at(time));
        path.push_back(at(set));
        paths.push_back(std::move(path));
    }
    return paths;
}

} // namespace edgeshade::sun
