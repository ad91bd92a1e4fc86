// sunhours --epw: energy of the direct beam against manual sums, bad weather files.
#include "tests/support/blocks.hpp"
#include "tests/support/csv_table.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/weather.hpp"
#include "tests/support/words.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

class SunHoursByWeather : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult result =
            run(WeatherText().text(), day + Words{"--grid", "16", "--step", "60"});
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
    }

    ProcessResult run(const std::string& weather, const Words& more) {
        return runEdgeshade(
            Words{"sunhours", folder_.write("scene.glb", blocksOnALawn({{{-1, 0, -1}, {1, 2, 1}}})),
                  csv_, "--surfaces", "--report", report_, "--epw",
                  folder_.write("station.epw", weather)} +
            more);
    }
    CsvTable table() const { return readCsv(csv_); }
    Json report() const {
        const Bytes bytes = readFile(report_);
        return Json::parse(bytes.begin(), bytes.end());
    }

    const Words day = {"--date", "2026-03-21"};
    const Words kwh = {"--quantity", "direct-kwh"};
    const TempFolder folder_;
    const std::string csv_ = folder_ / "cells.csv", report_ = folder_ / "report.json";
};

/// The number of an hour of 2026, from 0, from a time such as "2026-03-21T06:20+01:00".
std::size_t hourOfYear(const std::string& time) {
    constexpr std::array before = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    const int month = std::stoi(time.substr(5, 2)), day = std::stoi(time.substr(8, 2)),
              hour = std::stoi(time.substr(11, 2));
    return static_cast<std::size_t>(24 * (before[static_cast<std::size_t>(month - 1)] + day - 1) +
                                    hour);
}

} // namespace

TEST_F(SunHoursByWeather, PlaceAndZoneAreTheFiles) {
    WeatherText text;
    text.location = "LOCATION,Bangalore,KA,IND,made up,000000,12.97,77.58,5.5,921.0";
    const ProcessResult result = run(text.text(), day + Words{"--grid", "16", "--step", "60"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err.find("Clock"), std::string::npos) << result.err;
    const Json settings = report()["settings"];
    EXPECT_EQ(settings["place"], (Json{12.97, 77.58}));
    EXPECT_EQ(settings["utc-offset"], "+05:30");
    EXPECT_EQ(settings["epw"]["station"], "Bangalore, IND");
    EXPECT_EQ(settings["epw"]["file"], "station.epw");
    EXPECT_FALSE(report().contains("direct_kwh"));
}

TEST_F(SunHoursByWeather, OfAFreeRoofTheEnergyIsTheSumByHand) {
    // A year: on a level roof that nothing shades, each hour's radiation by the mean sine of the
    // altitude at its positions with sun.
    ASSERT_EQ(run(WeatherText().text(), Words{"--from", "2026-01-01", "--to", "2026-12-31",
                                              "--step", "20", "--grid", "2", "--nodes", "block 1"} +
                                            kwh)
                  .status,
              0);
    std::map<std::size_t, std::pair<double, int>> sines; // sum and number, by hour
    const Json found = report();
    for (const auto& position : found["positions"]) {
        auto& [sum, count] = sines[hourOfYear(position["time"])];
        sum += std::sin(glm::radians(position["altitude"].get<double>()));
        ++count;
    }
    double byHand = 0.0;
    for (const auto& [hour, sum] : sines)
        byHand += static_cast<double>(hour % 1000) * sum.first / sum.second / 1000.0;
    const CsvTable cells = table();
    std::size_t roofs = 0;
    double all = 0.0;
    for (std::size_t i = 0; i < cells.at("x").size(); ++i) {
        if (!cells.at("left_out")[i].empty()) continue;
        const double energy = std::stod(cells.at("direct_kwh_per_m2")[i]);
        all += energy * std::stod(cells.at("area_m2")[i]);
        if (cells.at("ny")[i] != "1") continue;
        EXPECT_NEAR(energy, byHand, 1e-9 * byHand);
        ++roofs;
    }
    EXPECT_EQ(roofs, 1u);
    EXPECT_GT(byHand, 500.0);
    EXPECT_NEAR(found["direct_kwh"].get<double>(), all, 1e-9 * all);
    EXPECT_NEAR(found["direct_kwh_per_m2"]["max"].get<double>(), byHand, 1e-9 * byHand);
}

TEST_F(SunHoursByWeather, WallsHaveTheirOwnAngles) {
    ASSERT_EQ(run(WeatherText().text(),
                  day + kwh + Words{"--step", "60", "--grid", "2", "--nodes", "block 1"})
                  .status,
              0);
    const CsvTable cells = table();
    const Json positions = report()["positions"];
    for (std::size_t i = 0; i < cells.at("x").size(); ++i) {
        if (!cells.at("left_out")[i].empty()) continue;
        const glm::dvec3 normal(std::stod(cells.at("nx")[i]), std::stod(cells.at("ny")[i]),
                                std::stod(cells.at("nz")[i]));
        double byHand = 0.0;
        for (const auto& position : positions) {
            const glm::dvec3 sun(position["direction"][0].get<double>(),
                                 position["direction"][1].get<double>(),
                                 position["direction"][2].get<double>());
            byHand += std::max(0.0, glm::dot(normal, sun)) / 1000.0 *
                      static_cast<double>(hourOfYear(position["time"]) % 1000);
        }
        EXPECT_NEAR(std::stod(cells.at("direct_kwh_per_m2")[i]), byHand, 1e-9) << i;
    }
}

TEST_F(SunHoursByWeather, BadFilesAndUsageAreOneSentence) {
    struct Row {
        std::string weather;
        Words words;
        int status;
        std::string said;
    };
    WeatherText shuffled, text;
    shuffled.setField(30, 1, "7");
    text.setField(40, 14, "cloudy");
    const std::string good = WeatherText().text();
    const Row rows[] = {
        {"", day, 2, "doesn't begin with LOCATION"},
        {std::string(1000, '\0'), day, 2, "doesn't begin with LOCATION"},
        {"LOCATION,here\n", day, 2, "has 2 fields"},
        {good.substr(0, 5000), day, 2, "hours, but a year has"},
        {shuffled.text(), day, 2, "days must be in order"},
        {text.text(), day, 2, "'cloudy', which is not a number"},
        {good, {}, 1, "--date"},
        {good, day + Words{"--place", "48,11"}, 1, "--place"},
        {good, day + Words{"--quantity", "lux"}, 1, "lux"},
        {good, day + kwh + Words{"--step", "120"}, 1, "120 does not divide an hour"},
    };
    for (const Row& row : rows) {
        std::filesystem::remove(csv_);
        const ProcessResult result = run(row.weather, row.words);
        EXPECT_EQ(result.status, row.status) << row.said << ": " << result.err;
        EXPECT_NE(result.err.find(row.said), std::string::npos) << row.said << ": " << result.err;
        const auto lines = std::ranges::count(result.err, '\n');
        EXPECT_TRUE(row.status == 1 || lines == 1) << result.err;
        EXPECT_FALSE(std::filesystem::exists(csv_));
    }
    const std::string scene = folder_ / "scene.glb";
    const ProcessResult missing = runEdgeshade(
        Words{"sunhours", scene, csv_, "--surfaces", "--epw", folder_ / "none.epw"} + day);
    EXPECT_EQ(missing.status, 2);
    EXPECT_NE(missing.err.find("none.epw' does not exist"), std::string::npos) << missing.err;
    EXPECT_EQ(
        runEdgeshade(Words{"sunhours", scene, csv_, "--surfaces", "--place", "48,11"} + day + kwh)
            .status,
        1);
}

} // namespace edgeshade::test
