#include "tests/cli/documented.hpp"
#include "tests/sun/judges.hpp"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

namespace edgeshade::test {
namespace {

using namespace std::chrono_literals;
using sun::Instant;
using sun::localTimeFromText;
using sun::Place;
using sun::sunPosition;

Instant at(const char* text) {
    return localTimeFromText(text).instant;
}

constexpr double enough = 0.01; ///< degrees: the accuracy that planners need, 1/50 of the sun's
                                ///< disc

/// The largest angle to a judge over this many random places and times.
double farthest(Judgement (*judge)(const Place&, Instant), int count) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> latitude(-90.0, 90.0), longitude(-180.0, 180.0);
    std::uniform_int_distribution<std::int64_t> seconds(
        at("1900-01-01T00:00Z").time_since_epoch().count(),
        at("2100-12-31T23:59Z").time_since_epoch().count());
    double most = 0.0;
    for (int i = 0; i < count; ++i) {
        const Place place{latitude(random), longitude(random)};
        const Instant time{std::chrono::seconds(seconds(random))};
        most = std::max(most, apart(judge(place, time), sunPosition(place, time)));
    }
    return most;
}

} // namespace

// Reda and Andreas, Solar Position Algorithm for Solar Radiation Applications, NREL/TP-560-34302,
// appendix A.5: 1830 m up, 820 mbar, 11 degrees Celsius.
TEST(Ephemeris, MatchesTheExampleThatNrelPublished) {
    const Place golden{39.742476, -105.1786};
    const auto found = sunPosition(golden, at("2003-10-17T12:30:30-07:00"), {820.0, 11.0});
    const struct {
        const char* name;
        double published, here;
    } rows[] = {{"topocentric zenith angle, refracted", 50.111622, 90.0 - found.altitude},
                {"azimuth from north", 194.340241, found.azimuth},
                {"altitude without refraction", 39.872046, found.airlessAltitude},
                {"refraction", 0.016332, found.altitude - found.airlessAltitude}};
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        EXPECT_NEAR(row.here, row.published, 0.001) << row.name;
        char line[160];
        std::snprintf(line, sizeof line, "| %s | %.5f | %.5f | %.5f |", row.name, row.published,
                      row.here, row.here - row.published);
        lines.push_back(line);
    }
    expectDocumented("example", lines, "measured/sun-positions.md");
}

TEST(Ephemeris, KeepsWithinALimitOfTwoJudges) {
    std::vector<std::string> lines;
    const auto judge = [&](const char* name, Judgement (*judgement)(const Place&, Instant)) {
        const double most = farthest(judgement, 20000);
        EXPECT_LT(most, enough) << name;
        char line[80];
        std::snprintf(line, sizeof line, "| %s | %.4f |", name, most);
        lines.push_back(line);
    };
    judge("full models", fullModel);
    judge("libnova", libnova);
    expectDocumented("everywhere", lines, "measured/sun-positions.md");
}

TEST(Ephemeris, BothSidesOfTheDateLineAreOnePlace) {
    const Instant time = at("2026-03-20T09:00+12:00");
    const auto east = sunPosition({-16.8, 180.0}, time);
    const auto west = sunPosition({-16.8, -180.0}, time);
    EXPECT_NEAR(east.azimuth, west.azimuth, 1e-9);
    EXPECT_NEAR(east.altitude, west.altitude, 1e-9);
    // The same moment on clocks on the other side, which show the day before.
    EXPECT_EQ(at("2026-03-19T09:00-12:00"), time);
}

TEST(Ephemeris, AtThePolesTheAltitudeIsTheDeclination) {
    const Instant solstice = at("2026-06-21T08:25Z");
    EXPECT_NEAR(sunPosition({90.0, 0.0}, solstice).airlessAltitude, 23.436, 0.005);
    EXPECT_NEAR(sunPosition({-90.0, 0.0}, solstice).airlessAltitude, -23.441, 0.005);
    // At the pole every direction is south; azimuths refer to the longitude that was given.
    const auto noon = sunPosition({90.0, 0.0}, at("2026-06-21T12:02Z"));
    EXPECT_NEAR(noon.azimuth, 180.0, 0.5);
}

TEST(Ephemeris, AzimuthsGoFromNorthByEast) {
    const Place equator{0.0, 0.0};
    EXPECT_NEAR(sunPosition(equator, at("2026-03-20T07:00Z")).azimuth, 90.0, 1.0);
    EXPECT_NEAR(sunPosition(equator, at("2026-03-20T17:00Z")).azimuth, 270.0, 1.0);
    EXPECT_GT(sunPosition(equator, at("2026-03-20T12:07Z")).altitude, 89.0);
    // In the south the sun is in the north at noon, and moves to the left.
    const Place sydney{-33.87, 151.21};
    EXPECT_LT(sunPosition(sydney, at("2026-12-21T11:00+11:00")).azimuth, 90.0);
    EXPECT_GT(sunPosition(sydney, at("2026-12-21T15:00+11:00")).azimuth, 270.0);
}

TEST(Ephemeris, NothingJumpsOverALeapDayOrALeapSecond) {
    const Place munich{48.14, 11.57};
    for (const char* start : {"2024-02-28T11:00Z", "2016-12-30T11:00Z", "1971-12-30T11:00Z"}) {
        const Instant first = at(start);
        double last = sunPosition(munich, first).altitude, rise = 0.0;
        for (int day = 1; day <= 3; ++day) {
            const double altitude = sunPosition(munich, first + 24h * day).altitude;
            if (day > 1) {
                EXPECT_NEAR(altitude - last, rise, 0.02) << start << " day " << day;
            }
            rise = altitude - last;
            last = altitude;
        }
    }
}

TEST(Ephemeris, APlaceIsRefusedThatIsNotOnEarth) {
    for (const auto& [latitude, longitude, word] : {std::tuple{90.1, 0.0, "latitude"},
                                                    {-91.0, 0.0, "latitude"},
                                                    {0.0, 180.5, "longitude"},
                                                    {std::nan(""), 0.0, "latitude"},
                                                    {0.0, std::nan(""), "longitude"}})
        try {
            sun::placeAt(latitude, longitude);
            ADD_FAILURE() << latitude << "," << longitude;
        } catch (const std::exception& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    EXPECT_EQ(sun::placeAt(-90.0, 180.0), (Place{-90.0, 180.0}));
}

} // namespace edgeshade::test
