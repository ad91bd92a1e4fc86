#include "src/hours/schedule.hpp"

#include "preprocess/base/error.hpp"

#include <cmath>
#include <string>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

void require(const Schedule& schedule) {
    if (schedule.to < schedule.from)
        throw Error(ExitStatus::usage, "--to: " + sun::textOf(schedule.to) + " is before --from, " +
                                           sun::textOf(schedule.from) + ".");
    if (schedule.opens < minutes(0) || schedule.closes > days(1) ||
        schedule.opens >= schedule.closes)
        throw Error(ExitStatus::usage,
                    "--hours: the first clock hour must be before the last, both from 0 to 24.");
    const minutes length = schedule.closes - schedule.opens;
    if (schedule.step < minutes(1) || length % schedule.step != minutes(0))
        throw Error(ExitStatus::usage,
                    "--step: " + std::to_string(schedule.step.count()) + " does not divide the " +
                        std::to_string(length.count()) + " minutes of a day that --hours leaves.");
    // Refuses years of minutes before computing them. The sun is up half of the time.
    constexpr std::size_t mostIntervals = 4 * mostPositions;
    if (schedule.days() * static_cast<std::size_t>(length / schedule.step) > mostIntervals)
        throw Error(ExitStatus::usage,
                    "--step: " + std::to_string(schedule.days()) + " days by steps of " +
                        std::to_string(schedule.step.count()) + " minutes far exceed the " +
                        std::to_string(mostPositions) +
                        " sun positions of one run; take a longer --step, or fewer days.");
}

} // namespace

minutes offsetNear(double longitude) {
    return minutes(60 * std::lround(longitude / 15.0));
}

std::vector<Position> positionsOf(const Schedule& schedule) {
    require(schedule);
    std::vector<Position> positions;
    for (sys_days day = schedule.from; day <= schedule.to; day += days(1)) {
        const sun::Instant midnight = sys_seconds(day) - schedule.offset;
        const std::vector<Position> ofDay =
            positionsBetween(schedule.place, midnight + schedule.opens, midnight + schedule.closes,
                             schedule.step, schedule.minAltitude, schedule.north);
        positions.insert(positions.end(), ofDay.begin(), ofDay.end());
        if (positions.size() > mostPositions)
            throw Error(ExitStatus::usage,
                        "--step: the sun has more than " + std::to_string(mostPositions) +
                            " positions in these days, which is the most that can be counted; take "
                            "a longer --step, or fewer days. --part splits work, not counts.");
    }
    return positions;
}

} // namespace edgeshade::hours
