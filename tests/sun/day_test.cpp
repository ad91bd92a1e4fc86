#include "src/sun/day.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using namespace std::chrono_literals;
using namespace sun;

Instant at(const char* text) {
    return localTimeFromText(text).instant;
}

/// The crossings of that day, by the text's clock.
std::vector<Crossing> crossingsOn(const Place& place, const char* day,
                                  const Horizon& horizon = lightHorizon) {
    const Instant start = startOfDay(localTimeFromText(day));
    return crossings(place, start, start + 24h, horizon);
}

std::vector<std::vector<TimedPosition>> pathsOn(const Place& place, const char* day) {
    const Instant start = startOfDay(localTimeFromText(day));
    return sunPaths(place, start, start + 24h, 10min);
}

const Place tromso{69.65, 18.96};

} // namespace

// NREL's example gives 06:12:43 and 17:20:19 in Golden. In UTC this day's sunset is the one of the
// evening before.
TEST(SunDay, SunriseAndSunsetAreThosePublished) {
    const auto found = crossings({39.742476, -105.1786}, at("2003-10-17T00:00Z"),
                                 at("2003-10-18T00:00Z"), almanacHorizon);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_FALSE(found[0].rising);
    EXPECT_TRUE(found[1].rising);
    EXPECT_LE(std::chrono::abs(found[0].time - at("2003-10-16T17:20:19-07:00")), 3s);
    EXPECT_LE(std::chrono::abs(found[1].time - at("2003-10-17T06:12:43-07:00")), 3s);
}

TEST(SunDay, ACrossingIsTheFirstSecondAfterIt) {
    const Place munich{48.14, 11.57};
    const auto found = crossingsOn(munich, "2026-06-21T12:00+02:00");
    ASSERT_EQ(found.size(), 2u);
    for (const Crossing& crossing : found) {
        EXPECT_EQ(sunPosition(munich, crossing.time).isUp(), crossing.rising);
        EXPECT_NE(sunPosition(munich, crossing.time - 1s).isUp(), crossing.rising);
    }
}

TEST(SunDay, ThePolarDayHasNoSunset) {
    EXPECT_TRUE(crossingsOn(tromso, "2026-06-21T12:00+02:00").empty());
    const auto paths = pathsOn(tromso, "2026-06-21T12:00+02:00");
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_EQ(paths[0].size(), 145u); // both midnights
    for (const TimedPosition& on : paths[0])
        EXPECT_GT(on.position.altitude, 3.0);
}

TEST(SunDay, ThePolarNightHasNoSunrise) {
    const Place longyearbyen{78.22, 15.65};
    EXPECT_TRUE(crossingsOn(longyearbyen, "2026-12-21T12:00+01:00").empty());
    EXPECT_TRUE(pathsOn(longyearbyen, "2026-12-21T12:00+01:00").empty());
    EXPECT_FALSE(sunPosition(longyearbyen, at("2026-12-21T12:00+01:00")).isUp());
}

// Where day and night are shortest: the sun turns just past the horizon, for less than one step.
TEST(SunDay, TheShortestDaysAndNightsAreFound) {
    int shortest = 24 * 60, days = 0, short_ = 0;
    for (Instant start = at("2026-05-10T00:00+01:00"); start < at("2026-05-25T00:00+01:00");
         start += 24h) {
        for (double latitude = 69.0; latitude < 71.0; latitude += 0.02) {
            const auto found = crossings({latitude, 18.96}, start, start + 24h);
            ++days;
            for (std::size_t i = 0; i + 1 < found.size(); ++i) {
                EXPECT_NE(found[i].rising, found[i + 1].rising);
                if (found[i].rising) continue;
                const auto night = static_cast<int>((found[i + 1].time - found[i].time) / 1min);
                shortest = std::min(shortest, night);
                short_ += night < 10;
            }
        }
    }
    EXPECT_LT(shortest, 10);
    EXPECT_GT(short_, 0);
    EXPECT_GE(days, 15 * 100);
}

// The crossings of every day of a year at the polar circle, against checks every 20 seconds.
TEST(SunDay, CrossingsAreThoseSeenSecondBySecond) {
    const Place circle{65.75, 25.0};
    for (Instant start = at("2026-06-05T00:00+02:00"); start < at("2026-06-14T00:00+02:00");
         start += 24h) {
        std::size_t seen = 0;
        bool up = sunPosition(circle, start).isUp();
        for (Instant time = start; time <= start + 24h; time += 20s) {
            const bool now = sunPosition(circle, time).isUp();
            seen += now != up;
            up = now;
        }
        EXPECT_EQ(crossings(circle, start, start + 24h).size(), seen);
    }
}

TEST(SunDay, AMidnightWithinTheDayPartsItsPath) {
    // Hawaii's day on a clock that is 12 hours off.
    const auto paths = pathsOn({20.0, -156.0}, "2026-03-20T12:00+02:00");
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(paths[0].front().time, at("2026-03-20T00:00+02:00"));
    EXPECT_EQ(paths[1].back().time, at("2026-03-21T00:00+02:00"));
    EXPECT_NEAR(paths[0].back().position.altitude, 0.0, 0.01);
    EXPECT_NEAR(paths[1].front().position.altitude, 0.0, 0.01);
}

TEST(SunDay, PathsBeginAndEndOnTheHorizonAndKeepTheStep) {
    const auto paths = pathsOn({-33.87, 151.21}, "2026-12-21T12:00+11:00");
    ASSERT_EQ(paths.size(), 1u);
    const auto& path = paths[0];
    EXPECT_NEAR(path.front().position.altitude, 0.0, 0.01);
    EXPECT_NEAR(path.back().position.altitude, 0.0, 0.01);
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
        EXPECT_EQ((path[i].time - at("2026-12-21T00:00+11:00")) % 10min, 0s);
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_GT(path[i].time, path[i - 1].time);
        EXPECT_LE(path[i].time - path[i - 1].time, 10min);
    }
}

TEST(SunDay, PositionsOverADayKeepTheStep) {
    const Place place{48.14, 11.57};
    const Instant start = at("2026-06-21T00:00+02:00");
    const auto positions = positionsBetween(place, start, start + 24h, 10min);
    ASSERT_EQ(positions.size(), 144u);
    EXPECT_EQ(positions.front().time, start);
    EXPECT_EQ(positions.back().time, start + 23h + 50min);
    EXPECT_EQ(positions[60].position.altitude, sunPosition(place, start + 10h).altitude);
    EXPECT_TRUE(positionsBetween(place, start, start, 10min).empty());
}

} // namespace edgeshade::test
