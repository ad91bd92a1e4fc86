#include "src/hours/weather_file.hpp"

#include "src/hours/beam.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/weather.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace edgeshade::hours {
namespace {

using namespace std::chrono_literals;
using test::WeatherText;

Weather read(const std::string& text) {
    const test::TempFolder folder;
    return readWeather(folder.write("station.epw", text));
}

sun::Instant at(const char* time) {
    return sun::localTimeFromText(time).instant;
}

/// The message of a file that can't be read.
std::string faultOf(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "it was read";
}

} // namespace

TEST(WeatherFile, HasPlaceZoneAndHours) {
    const Weather weather = read(WeatherText().text());
    EXPECT_EQ(weather.station, "Testville, UTO");
    EXPECT_EQ(weather.place, (sun::Place{48.14, 11.57}));
    EXPECT_EQ(weather.offset, 60min);
    ASSERT_EQ(weather.directNormal.size(), 8760u);
    EXPECT_EQ(weather.missing, 0u);
    // The first hour is from 0:00 on; WeatherText numbers them.
    EXPECT_EQ(weather.directNormal[0], 0.0);
    EXPECT_EQ(weather.directNormal[8759], 8759 % 1000);
}

TEST(WeatherFile, FindsTheHourOfAnyYear) {
    const Weather weather = read(WeatherText().text());
    EXPECT_EQ(weather.hourOf(at("2026-01-01T00:00+01:00")), 0u);
    EXPECT_EQ(weather.hourOf(at("2026-01-01T01:59+01:00")), 1u);
    EXPECT_EQ(weather.hourOf(at("2025-12-31T23:00Z")), 0u);
    EXPECT_EQ(weather.hourOf(at("2026-03-01T00:00+01:00")), 24u * 59);
    EXPECT_EQ(weather.hourOf(at("2028-03-01T00:00+01:00")), 24u * 59);
    EXPECT_EQ(weather.hourOf(at("2028-02-29T05:00+01:00")), 24u * 58 + 5); // as on the 28th
    EXPECT_EQ(weather.hourOf(at("2026-12-31T23:59+01:00")), 8759u);
}

TEST(WeatherFile, MayHaveALeapDayOtherLineEndsAndMissingValues) {
    WeatherText leap;
    leap.leap = true;
    const Weather weather = read(leap.text());
    EXPECT_EQ(weather.directNormal.size(), 8784u);
    EXPECT_EQ(weather.hourOf(at("2028-02-29T05:00+01:00")), 24u * 59 + 5);
    EXPECT_EQ(weather.hourOf(at("2026-03-01T00:00+01:00")), 24u * 60);
    WeatherText gaps;
    gaps.lineEnd = "\r\n";
    gaps.setField(100, 14, "9999");
    const Weather some = read("\xEF\xBB\xBF" + gaps.text());
    EXPECT_EQ(some.missing, 1u);
    EXPECT_EQ(some.directNormal[100], 0.0);
    EXPECT_EQ(some.directNormal[101], 101.0);
}

TEST(WeatherFile, FaultsNameFileLineAndValue) {
    const auto with = [](std::size_t hour, std::size_t field, const char* value) {
        WeatherText text;
        text.setField(hour, field, value);
        return text.text();
    };
    const auto located = [](const char* latitude, const char* longitude, const char* zone) {
        WeatherText text;
        text.location =
            std::string("LOCATION,a,b,c,d,1,") + latitude + "," + longitude + "," + zone + ",0";
        return text.text();
    };
    const std::pair<std::string, std::string> rows[] = {
        {"", "doesn't begin with LOCATION"},
        {"glTF\x02", "doesn't begin with LOCATION"},
        {"LOCATION,a,b,c\n", "line 1: has 4 fields, and so no latitude"},
        {located("north", "11", "1"), "line 1: latitude is 'north', which is not a number"},
        {located("nan", "11", "1"), "latitude is 'nan', which is not a number"},
        {located("91", "11", "1"), "latitude is 91, but must be from -90 to 90"},
        {located("48", "181", "1"), "longitude is 181"},
        {located("48", "11", "15"), "time zone is 15, but must be from -12 to 14"},
        {"LOCATION,a,b,c,d,1,48,11,1,0\n", "has no line of DATA PERIODS"},
        {"LOCATION,a,b,c,d,1,48,11,1,0\nDATA PERIODS,1,4,Data,Sunday,1/1,12/31\n",
         "line 2: has '4' records an hour"},
        {"LOCATION,a,b,c,d,1,48,11,1,0\nDATA PERIODS,1,1,Data,Sunday,1/1,12/31\n", "has 0 hours"},
        {with(5, 1, "13"), "line 14: month is 13, but must be from 1 to 12"},
        {with(5, 1, "2.5"), "month is 2.5, which is not a whole number"},
        {with(24 * 31, 2, "30"), "day is 30, but must be from 1 to 29"},
        {with(5, 3, "25"), "hour is 25, but must be from 1 to 24"},
        {with(5, 3, "7"), "hour is 7, but the line before it makes 6 the next"},
        {with(5, 2, "2"), "has month 1, day 2 in its 6. hour"},
        {with(5, 14, "-1"), "direct normal radiation is -1, but must not be negative"},
        {with(5, 14, "sunny"), "direct normal radiation is 'sunny', which is not a number"},
        {with(5, 14, "inf"), "'inf', which is not a number"},
        {WeatherText().text().substr(0, 300000), "hours, but a year has 8760 or 8784"},
        {WeatherText().text() + "1999,1,1,1,0,?,1,1,1,1,1,1,1,1,1\n", "8761 hours"},
    };
    for (const auto& [text, said] : rows) {
        const std::string fault = faultOf(text);
        EXPECT_NE(fault.find(said), std::string::npos) << said << ": " << fault;
        EXPECT_NE(fault.find("station.epw'"), std::string::npos) << fault;
        EXPECT_TRUE(fault.ends_with(".")) << fault;
    }
    EXPECT_THROW(readWeather("/nowhere/station.epw"), InputError);
    EXPECT_THROW(readWeather(test::TempFolder().write("a.epw", WeatherText().text()), 1000),
                 InputError);
}

TEST(Beam, SharesAnHourByThePositionsOfTheDay) {
    // Every hour of 21 March has the same energy: positions of whole hours of day have it as their
    // irradiance, and those of the hours of sunrise and sunset more.
    WeatherText text;
    for (std::size_t hour = 0; hour < 8760; ++hour)
        text.setField(hour, 14, "600");
    const Weather weather = read(text.text());
    for (const int step : {5, 10, 60}) {
        const std::vector<Position> day =
            positionsBetween(weather.place, at("2026-03-21T00:00+01:00"),
                             at("2026-03-22T00:00+01:00"), std::chrono::minutes(step), 0.0, 0.0);
        const std::vector<double> beam = beamOf(weather, day, std::chrono::minutes(step));
        std::map<std::size_t, double> energies; // Wh/m², by hour
        for (std::size_t i = 0; i < day.size(); ++i)
            energies[weather.hourOf(day[i].time)] += beam[i] * step / 60.0;
        EXPECT_GE(energies.size(), 12u);
        for (const auto& [hour, energy] : energies)
            EXPECT_NEAR(energy, 600.0, 1e-9) << hour;
        EXPECT_NEAR(beam[beam.size() / 2], 600.0, 1e-9);
    }
}

TEST(Beam, CountsOnlyItsOwnPositionsOfAnHour) {
    // Clock hours from 9:30 on have half of the hour's energy.
    WeatherText text;
    text.setField(24 * 79 + 9, 14, "600"); // 21 March, 9:00 to 10:00
    const Weather weather = read(text.text());
    const std::vector<Position> half = positionsBetween(
        weather.place, at("2026-03-21T09:30+01:00"), at("2026-03-21T10:00+01:00"), 10min, 0.0, 0.0);
    const std::vector<double> beam = beamOf(weather, half, 10min);
    ASSERT_EQ(beam.size(), 3u);
    EXPECT_NEAR(std::accumulate(beam.begin(), beam.end(), 0.0) / 6.0, 300.0, 1e-9);
    EXPECT_THROW(beamOf(weather, half, 7min), Error);
    EXPECT_THROW(beamOf(weather, half, 120min), Error);
}

} // namespace edgeshade::hours
