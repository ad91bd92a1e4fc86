#include "preprocess/base/error.hpp"
#include "src/hours/schedule.hpp"
#include "src/sun/day.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

/// Munich on the equinox, on its winter clock.
Schedule equinox() {
    Schedule schedule;
    schedule.place = sun::placeAt(48.14, 11.57);
    schedule.offset = minutes(60);
    schedule.from = schedule.to = sys_days(2026y / March / 21);
    return schedule;
}

std::string messageOf(const Schedule& schedule) {
    try {
        positionsOf(schedule);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::usage);
        return error.what();
    }
    return "";
}

} // namespace

TEST(Schedule, PositionsAreTheMiddlesOfSteps) {
    Schedule schedule = equinox();
    schedule.opens = minutes(9 * 60);
    schedule.closes = minutes(17 * 60);
    schedule.step = minutes(30);
    const std::vector<Position> positions = positionsOf(schedule);
    ASSERT_EQ(positions.size(), 16u);
    EXPECT_EQ(sun::textOf(sun::LocalTime{positions.front().time, schedule.offset}),
              "2026-03-21T09:15+01:00");
    EXPECT_EQ(sun::textOf(sun::LocalTime{positions.back().time, schedule.offset}),
              "2026-03-21T16:45+01:00");
    for (const Position& position : positions)
        EXPECT_NEAR(position.direction.y, std::sin(position.altitude * 3.14159265358979 / 180.0),
                    1e-12);
}

TEST(Schedule, OddStepsHaveHalfMinutes) {
    Schedule schedule = equinox();
    schedule.step = minutes(15);
    const std::vector<Position> positions = positionsOf(schedule);
    EXPECT_EQ(sun::textOf(sun::LocalTime{positions.front().time, schedule.offset}).substr(13, 6),
              ":22:30");
}

TEST(Schedule, AnEquinoxDayHasTwelveHoursAndWhatRefractionAdds) {
    const std::vector<Position> positions = positionsOf(equinox());
    EXPECT_GE(positions.size(), 72u);
    EXPECT_LE(positions.size(), 74u);
    // Each position stands for a step within the arc between rise and set.
    const sun::Instant midnight = sys_seconds(equinox().from) - minutes(60);
    const auto crossings = sun::crossings(equinox().place, midnight, midnight + days(1));
    ASSERT_EQ(crossings.size(), 2u);
    EXPECT_GT(positions.front().time, crossings[0].time);
    EXPECT_LT(positions.front().time - crossings[0].time, minutes(10));
    EXPECT_LT(positions.back().time, crossings[1].time);
    EXPECT_LT(crossings[1].time - positions.back().time, minutes(10));
}

TEST(Schedule, LowSunIsLeftOut) {
    Schedule schedule = equinox();
    schedule.minAltitude = 20.0;
    const std::vector<Position> positions = positionsOf(schedule);
    ASSERT_FALSE(positions.empty());
    EXPECT_LT(positions.size(), positionsOf(equinox()).size());
    for (const Position& position : positions)
        EXPECT_GT(position.altitude, 20.0);
}

TEST(Schedule, NorthTurnsDirections) {
    Schedule schedule = equinox();
    const std::vector<Position> straight = positionsOf(schedule);
    schedule.north = 90.0; // +X is north, and +Z east
    const std::vector<Position> turned = positionsOf(schedule);
    ASSERT_EQ(turned.size(), straight.size());
    for (std::size_t i = 0; i < turned.size(); ++i) {
        EXPECT_NEAR(turned[i].direction.x, -straight[i].direction.z, 1e-12);
        EXPECT_NEAR(turned[i].direction.z, straight[i].direction.x, 1e-12);
    }
}

TEST(Schedule, DaysAreInclusiveAndLeapDaysAreDays) {
    Schedule schedule = equinox();
    schedule.from = sys_days(2028y / February / 28);
    schedule.to = sys_days(2028y / March / 1);
    EXPECT_EQ(schedule.days(), 3u);
    schedule.opens = minutes(12 * 60);
    schedule.closes = minutes(13 * 60);
    schedule.step = minutes(60);
    EXPECT_EQ(positionsOf(schedule).size(), 3u);
}

TEST(Schedule, PolarNightHasNoneAndPolarDayAll) {
    Schedule schedule = equinox();
    schedule.place = sun::placeAt(78.2, 15.6);
    schedule.from = schedule.to = sys_days(2026y / December / 21);
    EXPECT_TRUE(positionsOf(schedule).empty());
    schedule.from = schedule.to = sys_days(2026y / June / 21);
    EXPECT_EQ(positionsOf(schedule).size(), 144u);
}

TEST(Schedule, RefusesWhatCantBeCounted) {
    Schedule schedule = equinox();
    schedule.step = minutes(7);
    EXPECT_NE(messageOf(schedule).find("--step: 7 does not divide the 1440 minutes"),
              std::string::npos);
    schedule = equinox();
    schedule.to -= days(1);
    EXPECT_NE(messageOf(schedule).find("--to: 2026-03-20 is before --from, 2026-03-21"),
              std::string::npos);
    schedule = equinox();
    schedule.opens = schedule.closes;
    EXPECT_NE(messageOf(schedule).find("--hours"), std::string::npos);
    schedule = equinox();
    schedule.to += days(365);
    schedule.step = minutes(4);
    const std::string message = messageOf(schedule);
    EXPECT_NE(message.find("--step: the sun has more than 65535 positions"), std::string::npos)
        << message;
    EXPECT_NE(message.find("--part"), std::string::npos);
    schedule.from = sys_days(1900y / January / 1);
    schedule.step = minutes(1);
    EXPECT_NE(messageOf(schedule).find("65535"), std::string::npos);
}

TEST(Schedule, ClocksAreWholeHoursNearTheLongitude) {
    EXPECT_EQ(offsetNear(11.57), minutes(60));
    EXPECT_EQ(offsetNear(7.4), minutes(0));
    EXPECT_EQ(offsetNear(-73.9), minutes(-300));
    EXPECT_EQ(offsetNear(180.0), minutes(720));
    EXPECT_EQ(offsetNear(-180.0), minutes(-720));
}

} // namespace edgeshade::hours
