// sunhours --surfaces: hours derived from geometry, choices, files, bad usage.
#include "tests/support/blocks.hpp"
#include "tests/support/csv_table.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/words.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <thread>

namespace edgeshade::test {
namespace {

/// Hours of one cell that are certain, in spite of rays that barely touch a block.
struct Bounds {
    double least, most;
};

class SunHoursOfSurfaces : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult result = run(blocksOnALawn({}), {"--grid", "16", "--step", "720"});
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
    }

    ProcessResult run(const Bytes& glb, const Words& more) {
        return runEdgeshade(Words{"sunhours", folder_.write("scene.glb", glb), csv_, "--surfaces",
                                  "--report", report_} +
                            equinox + more);
    }

    CsvTable table() const { return readCsv(csv_); }
    Json report() const {
        const Bytes bytes = readFile(report_);
        return Json::parse(bytes.begin(), bytes.end());
    }

    static glm::dvec3 vectorAt(const CsvTable& table, const char* names, std::size_t row) {
        const std::string name = names;
        const auto part = [&](char axis) { return std::stod(table.at(name + axis).at(row)); };
        return {part('x'), part('y'), part('z')};
    }

    /// Hours by the position's directions and the blocks alone.
    Bounds hoursByHand(const Json& positions, const std::vector<Block>& blocks,
                       const glm::dvec3& point, const glm::dvec3& normal, double step) const {
        Bounds lit{0, 0};
        for (const auto& position : positions) {
            const glm::dvec3 sun(position["direction"][0].get<double>(),
                                 position["direction"][1].get<double>(),
                                 position["direction"][2].get<double>());
            const auto isLit = [&](double margin) {
                return glm::dot(normal, sun) > margin &&
                       std::ranges::none_of(blocks, [&](const Block& block) {
                           return block.blocks(point + 1e-6 * normal, sun, margin);
                       });
            };
            lit.least += isLit(1e-5) ? step / 60.0 : 0.0;
            lit.most += isLit(-1e-5) ? step / 60.0 : 0.0;
        }
        return lit;
    }

    /// Every cell of the blocks and the lawn has the hours that its own ray test gives.
    void expectHoursByHand(const std::vector<Block>& blocks, const Words& more, double step) {
        ASSERT_EQ(run(blocksOnALawn(blocks), more).status, 0);
        const CsvTable cells = table();
        const Json found = report();
        std::vector<Block> all = blocks;
        all.push_back({{-8, -1, -8}, {8, 0, 8}});
        std::size_t checked = 0, lit = 0;
        for (std::size_t i = 0; i < cells.at("x").size(); ++i) {
            const glm::dvec3 point = vectorAt(cells, "", i), normal = vectorAt(cells, "n", i);
            const bool inside = std::ranges::any_of(
                all, [&](const Block& block) { return block.holds(point + 1e-6 * normal); });
            EXPECT_EQ(cells.at("left_out")[i], inside ? "inside" : "") << i;
            const double hours = std::stod(cells.at("hours")[i]);
            const Bounds byHand = hoursByHand(found["positions"], all, point, normal, step);
            EXPECT_GE(hours, byHand.least - 1e-9) << i;
            EXPECT_LE(hours, byHand.most + 1e-9) << i;
            ++checked;
            lit += hours > 0.0;
        }
        EXPECT_GT(checked, 100u);
        EXPECT_GT(lit, 50u);
    }

    const Words equinox = {"--place",    "48.14,11.57",  "--date",
                           "2026-03-21", "--utc-offset", "+01:00"};
    const TempFolder folder_;
    const std::string csv_ = folder_ / "cells.csv", report_ = folder_ / "report.json";
};

} // namespace

TEST_F(SunHoursOfSurfaces, OfABoxAreThoseWorkedOutByHand) {
    for (const char* north : {"0", "35"})
        expectHoursByHand({{{-1.5, 0, -1}, {1.25, 3, 1}}},
                          {"--grid", "1", "--step", "20", "--north", north}, 20.0);
}

TEST_F(SunHoursOfSurfaces, OfACourtyardAreThoseWorkedOutByHand) {
    expectHoursByHand({{{-4, 0, -4}, {4, 2, -3}},
                       {{-4, 0, 3}, {4, 2, 4}},
                       {{-4, 0, -3}, {-3, 2, 3}},
                       {{3, 0, -3}, {4, 2, 3}}},
                      {"--grid", "1.1", "--step", "20"}, 20.0);
}

TEST_F(SunHoursOfSurfaces, OfACanyonAreThoseWorkedOutByHandToTheMinute) {
    // A street of 4 between rows of houses of 6, along the meridian: at noon the sun shines along
    // it. The middle of the street, far from its ends, sees the sun while the shadow across the
    // street is shorter than 2: |tan(altitude)| > 3 |sin(azimuth)|.
    const std::vector<Block> rows = {{{-8, 0, -8}, {-2, 6, 8}}, {{2, 0, -8}, {8, 6, 8}}};
    expectHoursByHand(rows, {"--grid", "2", "--step", "15"}, 15.0);

    ASSERT_EQ(run(blocksOnALawn(rows), {"--grid", "16", "--step", "1", "--nodes", "lawn", "--when"})
                  .status,
              0);
    const CsvTable cells = table();
    const Json positions = report()["positions"];
    for (std::size_t i = 0; i < cells.at("x").size(); ++i) {
        if (vectorAt(cells, "n", i).y < 0.5) continue;
        const glm::dvec3 point = vectorAt(cells, "", i); // the lawn's middle
        ASSERT_LT(std::abs(point.x) + std::abs(point.z), 0.2);
        std::string first, last;
        std::size_t lit = 0;
        for (const auto& position : positions) {
            const glm::dvec3 sun(position["direction"][0].get<double>(),
                                 position["direction"][1].get<double>(),
                                 position["direction"][2].get<double>());
            // Towards the side that the sun is on, the wall is 2 away, less where the point is.
            const double away = sun.x > 0.0 ? 2.0 - point.x : 2.0 + point.x;
            if (std::abs(sun.x) * 6.0 >= sun.y * away) continue;
            if (lit++ == 0) first = position["time"];
            last = position["time"];
        }
        EXPECT_GT(lit, 60u);
        EXPECT_DOUBLE_EQ(std::stod(cells.at("hours")[i]), static_cast<double>(lit) / 60.0);
        // A position is in the middle of its minute: 12:00:30 is of the minute from 12:00 on.
        EXPECT_EQ(cells.at("first")[i].substr(0, 16), first.substr(0, 16));
        EXPECT_LT(last, cells.at("last")[i]);
    }
}

TEST_F(SunHoursOfSurfaces, AreasAreTheMeshesOwn) {
    const std::vector<Block> blocks = {{{-2, 0, -2}, {2, 1, 2}}, {{3, 0, 3}, {4, 5, 4.5}}};
    ASSERT_EQ(run(blocksOnALawn(blocks), {"--grid", "0.7", "--step", "240"}).status, 0);
    const CsvTable cells = table();
    double area = 0.0;
    for (const std::string& one : cells.at("area_m2"))
        area += std::stod(one);
    const double lawn = 2 * 256.0 + 4 * 16.0, first = 2 * 16.0 + 4 * 4.0,
                 second = 2 * 1.5 + 5 * 5.0;
    EXPECT_NEAR(area, lawn + first + second, 1e-9 * area);
    const Json found = report();
    EXPECT_NEAR(found["area"].get<double>() + found["inside_solids"]["area"].get<double>(), area,
                1e-9 * area);
    EXPECT_EQ(found["within_others"]["cells"], 0);
    // Beneath the first block the lawn has 16, and the block's underside lies in the lawn.
    EXPECT_NEAR(found["inside_solids"]["area"].get<double>(), 2 * (16.0 + 1.5), 5.0);
    double byNode = 0.0;
    for (const auto& node : found["by_node"])
        byNode += node["area"].get<double>();
    EXPECT_NEAR(byNode, found["area"].get<double>(), 1e-9 * area);
}

TEST_F(SunHoursOfSurfaces, UnitsAndOffsetsAreMetres) {
    // The same scene in centimetres: areas are in square metres, points in the scene's units.
    ASSERT_EQ(run(blocksOnALawn({}), {"--grid", "0.08", "--unit", "0.01", "--offset", "0.02",
                                      "--step", "720", "--nodes", "lawn"})
                  .status,
              0);
    const CsvTable cells = table();
    EXPECT_EQ(std::ranges::count(cells.at("ny"), "1"), 4);
    for (std::size_t i = 0; i < cells.at("x").size(); ++i)
        if (cells.at("ny")[i] == "1") {
            EXPECT_DOUBLE_EQ(std::stod(cells.at("area_m2")[i]), 0.0064);
            EXPECT_DOUBLE_EQ(std::stod(cells.at("y")[i]), 2.0);
        }
    EXPECT_EQ(report()["settings"]["surfaces"]["unit"], 0.01);
}

TEST_F(SunHoursOfSurfaces, ChoicesAreByNodeAndMaterial) {
    GltfBuilder gltf;
    const int brick = gltf.addMaterial({{"name", "brick"}});
    const int glass = gltf.addMaterial({{"name", "glass"}});
    const int leaf =
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1)), {{"material", glass}})},
                      {"translation", {5, 0, 0}}},
                     false);
    gltf.addNode({{"name", "house"},
                  {"mesh", gltf.addShape(box(glm::vec3(1)), {{"material", brick}})},
                  {"children", {leaf}}});
    gltf.addNode({{"name", "shed"},
                  {"mesh", gltf.addShape(box(glm::vec3(0.5f)))},
                  {"translation", {0, 0, 9}}});
    const auto cellsOf = [&](const Words& choice) {
        EXPECT_EQ(run(gltf.glb(), Words{"--grid", "2", "--step", "720"} + choice).status, 0);
        return table().at("x").size();
    };
    EXPECT_EQ(cellsOf({}), 18u);
    EXPECT_EQ(cellsOf({"--nodes", "shed"}), 6u);
    EXPECT_EQ(cellsOf({"--nodes", "house"}), 12u);
    EXPECT_EQ(cellsOf({"--nodes", "house", "--nodes", "shed"}), 18u);
    EXPECT_EQ(cellsOf({"--nodes", "house", "--materials", "glass"}), 6u);
    EXPECT_EQ(table().at("node")[0], "nodes[0]");
    EXPECT_EQ(cellsOf({"--materials", "default material"}), 6u);
}

TEST_F(SunHoursOfSurfaces, AYearHasTwelveColumns) {
    ASSERT_EQ(
        runEdgeshade({"sunhours", folder_.write("scene.glb", blocksOnALawn({})), csv_, "--surfaces",
                      "--nodes", "lawn", "--grid", "16", "--place", "48.14,11.57", "--from",
                      "2026-01-01", "--to", "2026-12-31", "--step", "60", "--report", report_})
            .status,
        0);
    const CsvTable cells = table();
    ASSERT_TRUE(cells.contains("hours_01"));
    std::map<std::string, double> byMonth;
    const Json positions = report()["positions"];
    for (const auto& position : positions)
        byMonth["hours_" + position["time"].get<std::string>().substr(5, 2)] += 1.0;
    for (std::size_t i = 0; i < cells.at("x").size(); ++i) {
        if (cells.at("ny")[i] != "1") continue;
        double sum = 0.0;
        for (const auto& [column, hours] : byMonth) {
            EXPECT_EQ(std::stod(cells.at(column)[i]), hours) << column;
            sum += hours;
        }
        EXPECT_EQ(std::stod(cells.at("hours")[i]), sum);
    }
    EXPECT_EQ(byMonth.size(), 12u);
}

TEST_F(SunHoursOfSurfaces, SeveralFilesComeFromOneRun) {
    const std::string scene = folder_.write("scene.glb", blocksOnALawn({}));
    const std::string glb = folder_ / "cells.glb", npy = folder_ / "bits.npy";
    const ProcessResult result =
        runEdgeshade(Words{"sunhours", scene, glb, csv_, npy, "--surfaces", "--grid", "4", "--step",
                           "60", "--report", report_} +
                     equinox);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, glb.size()), glb);
    EXPECT_NE(result.out.find("48 cells"), std::string::npos) << result.out;
    const std::size_t bytesOfRow = (report()["positions"].size() + 7) / 8;
    EXPECT_EQ(readFile(npy).size(), 128 + table().at("x").size() * bytesOfRow);
    // The mesh is a scene like any other.
    const ProcessResult info = runEdgeshade({"info", glb});
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_EQ(info.err, "");
    // Bits add up to hours.
    const Bytes bits = readFile(npy);
    for (std::size_t i = 0; i < table().at("x").size(); ++i) {
        int lit = 0;
        for (std::size_t b = 0; b < bytesOfRow; ++b)
            lit += std::popcount(bits[128 + i * bytesOfRow + b]);
        EXPECT_EQ(std::stod(table().at("hours")[i]), lit);
    }
}

TEST_F(SunHoursOfSurfaces, LightPassesThroughCutouts) {
    // A roof of a MASK material over the lawn's middle, which its alpha leaves or cuts out.
    const auto hoursBeneath = [&](double alpha, const Words& more) {
        GltfBuilder gltf;
        const int mask = gltf.addMaterial(
            {{"alphaMode", "MASK"},
             {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 1.0, 1.0, alpha}}}}});
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(8.0f, 0.5f, 8.0f)))},
                      {"name", "lawn"},
                      {"translation", {0, -0.5, 0}}});
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(6, 0.1f, 6)), {{"material", mask}})},
                      {"translation", {0, 1, 0}}});
        EXPECT_EQ(
            run(gltf.glb(), Words{"--grid", "16", "--step", "60", "--nodes", "lawn"} + more).status,
            0);
        const CsvTable cells = table();
        const auto top = std::ranges::find(cells.at("ny"), "1") - cells.at("ny").begin();
        return std::stod(cells.at("hours")[static_cast<std::size_t>(top)]);
    };
    const double all = hoursBeneath(1.0, {});
    EXPECT_GT(all, 10.0);
    EXPECT_EQ(hoursBeneath(0.1, {"--cast-cutouts"}), all);
    EXPECT_LT(hoursBeneath(1.0, {"--cast-cutouts"}), 0.5 * all);
    EXPECT_LT(hoursBeneath(0.1, {"--cast-masked"}), 0.5 * all);
}

TEST_F(SunHoursOfSurfaces, AThousandCellsAtRandomAreThoseOfTypedPoints) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-7.0, 7.0), size(0.1, 1.5);
    std::vector<Block> blocks;
    for (int i = 0; i < 30; ++i) {
        const glm::dvec3 middle(place(random), 0.5 * size(random), place(random)),
            half(size(random), 2.0 * size(random), size(random));
        blocks.push_back({middle - half, middle + half});
    }
    const Words day = {"--step", "30"};
    ASSERT_EQ(run(blocksOnALawn(blocks), day).status, 0);
    const std::string scene = folder_ / "scene.glb";
    const CsvTable cells = table();
    std::vector<std::size_t> chosen(cells.at("x").size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    std::erase_if(chosen, [&](std::size_t i) { return !cells.at("left_out")[i].empty(); });
    ASSERT_GT(chosen.size(), 2000u);
    std::shuffle(chosen.begin(), chosen.end(), random);
    chosen.resize(1000);
    Words points;
    for (const std::size_t i : chosen) {
        std::string point = "--at=";
        for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
            point += (point == "--at=" ? "" : ",") + cells.at(name)[i];
        points.push_back(point);
    }
    ASSERT_EQ(runEdgeshade(Words{"sunhours", scene, folder_ / "a.png", "--size", "8x8", "--report",
                                 report_} +
                           equinox + day + points)
                  .status,
              0);
    const Json probes = report()["probes"];
    ASSERT_EQ(probes.size(), 1000u);
    double sum = 0.0;
    for (std::size_t p = 0; p < 1000; ++p) {
        const double hours = std::stod(cells.at("hours")[chosen[p]]);
        EXPECT_EQ(probes[p]["hours"].get<double>(), hours) << points[p];
        sum += hours;
    }
    EXPECT_GT(sum, 1000.0);
}

TEST_F(SunHoursOfSurfaces, BadUsageIsOneSentence) {
    struct Row {
        Words words;
        std::string said;
    };
    const Row rows[] = {
        {{"--grid", "0"}, "--grid"},
        {{"--grid", "-1"}, "--grid"},
        {{"--grid", "nan"}, "--grid"},
        {{"--grid", "inf"}, "--grid"},
        {{"--grid", "1e-300"}, "--grid"},
        {{"--grid", "0.001"}, "more than 10000000"},
        {{"--grid", "half"}, "--grid"},
        {{"--offset", "-0.1"}, "--offset"},
        {{"--unit", "0"}, "--unit"},
        {{"--nodes", "tower"}, "has no node 'tower'"},
        {{"--materials", "brass"}, "has no material 'brass'"},
        {{"--plan"}, "--plan"},
        {{"--size", "9x9"}, "--size"},
        {{"--at", "0,0,0"}, "--at"},
        {{"--counts", "c.png"}, "--counts"},
        {{"--part", "1/2"}, "can't end in .glb"},
        {{"--by", "masks"}, "--by masks"},
        {{"--caster-error", "0.1"}, "--caster-error"},
        {{"--section", "1,0,0,0"}, "--section"},
    };
    const std::string scene = folder_.write("scene.glb", blocksOnALawn({}));
    const std::string out = folder_ / "bad.csv";
    const auto refuses = [&](const Words& words, const std::string& said) {
        const ProcessResult result = runEdgeshade(Words{"sunhours", scene} + words);
        EXPECT_EQ(result.status, 1) << said << ": " << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << said << ": " << result.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    for (const Row& row : rows)
        refuses(Words{out, "--surfaces"} + equinox + row.words, row.said);
    refuses(Words{folder_ / "bad.png", "--surfaces"} + equinox, "ends neither in .glb");
    refuses(Words{out} + equinox, "needs --surfaces");
    refuses(Words{folder_ / "a.png", folder_ / "b.png"} + equinox, "need --surfaces");
    for (const char* option : {"--grid", "--offset", "--unit"})
        refuses(Words{folder_ / "a.png", option, "1"} + equinox, "--surfaces");
    refuses(Words{folder_ / "a.png", "--when"} + equinox, "--surfaces");
    EXPECT_EQ(runEdgeshade(Words{"sunhours", scene, "/nowhere/a.csv", "--surfaces", "--grid", "16",
                                 "--step", "720"} +
                           equinox)
                  .status,
              4);
}

TEST_F(SunHoursOfSurfaces, InterruptedLeavesNoPartialFile) {
    for (const int delay : {20, 200, 600}) {
        const TempFolder folder;
        ChildProcess process(EDGESHADE_PROGRAM,
                             Words{"sunhours", std::string(EDGESHADE_ASSETS) + "/pavilion.glb",
                                   folder / "a.glb", folder / "a.csv", "--surfaces", "--grid",
                                   "0.02", "--step", "1", "--report", folder / "report.json"} +
                                 equinox);
        std::this_thread::sleep_for(std::chrono::milliseconds(delay));
        process.send(SIGINT);
        EXPECT_EQ(process.wait().signal, SIGINT);
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST_F(SunHoursOfSurfaces, ALogHasALineAStage) {
    const ProcessResult result = run(blocksOnALawn({}), {"--grid", "1", "--step", "240"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err.find_first_of("\r\033"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("progress: tracing rays to"), std::string::npos) << result.err;
    EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 3) << result.err;
}

} // namespace edgeshade::test
