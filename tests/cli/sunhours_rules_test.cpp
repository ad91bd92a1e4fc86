// sunhours --windows and presets over surfaces: verdicts against geometry, pages, bad usage.
#include "tests/support/blocks.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/words.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A house with a pane of glass of 2 x 2 on its south and on its north side, and a garden.
Bytes house() {
    GltfBuilder gltf;
    const int plaster = gltf.addMaterial({{"name", "plaster"}});
    const int glass = gltf.addMaterial({{"name", "glass"}, {"alphaMode", "BLEND"}});
    const auto add = [&](const char* name, const glm::vec3& half, const glm::dvec3& at,
                         int material) {
        gltf.addNode({{"name", name},
                      {"mesh", gltf.addShape(box(half), {{"material", material}})},
                      {"translation", {at.x, at.y, at.z}}});
    };
    add("house", {4, 3, 4}, {0, 3, 0}, plaster);
    add("south window", {1, 1, 0.02f}, {0, 3, 4.02}, glass);
    add("north window", {1, 1, 0.02f}, {0, 3, -4.02}, glass);
    add("garden", {3, 0.01f, 3}, {0, -0.01, 12}, plaster);
    return gltf.glb();
}

class SunHoursByRule : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult result = run({"--date", "2026-03-21", "--step", "720"});
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
    }

    ProcessResult run(const Words& more, const std::string& report = "report.json") {
        return runEdgeshade(Words{"sunhours", folder_.write("house.glb", house()),
                                  folder_ / "cells.csv", "--surfaces", "--place", "52.5,13.4",
                                  "--report", folder_ / report} +
                            more);
    }
    Json report() const {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }

    const TempFolder folder_;
};

} // namespace

TEST_F(SunHoursByRule, WindowsPassByTheSunThatTheyFace) {
    struct Row {
        const char* preset;
        double threshold, altitude;
        const char* date;
    };
    for (const Row& row : {Row{"din5034-winter", 1.0, 6.0, "2026-01-17"},
                           Row{"din5034-equinox", 4.0, 6.0, "2026-03-21"},
                           Row{"en17037-minimum", 1.5, 0.0, "2026-03-21"}}) {
        const ProcessResult result =
            run({"--windows", "glass", "--preset", row.preset, "--step", "10"});
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("1 of 2 windows pass"), std::string::npos) << result.out;
        const Json found = report();
        EXPECT_EQ(found["settings"]["min-altitude"], row.altitude);
        EXPECT_EQ(found["settings"]["from"], row.date);
        const Json rule = found["rule"];
        EXPECT_EQ(rule["preset"], row.preset);
        EXPECT_EQ(rule["threshold_hours"], row.threshold);
        EXPECT_EQ(rule["passes"], false);
        ASSERT_EQ(rule["checks"].size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            const Json check = rule["checks"][i];
            const double outwards = i == 0 ? 1.0 : -1.0;
            EXPECT_EQ(check["name"], i == 0 ? "south window" : "north window");
            EXPECT_NEAR(check["point"][2].get<double>(), outwards * 4.04, 1e-6);
            EXPECT_EQ(check["normal"], (Json{0.0, 0.0, outwards}));
            EXPECT_NEAR(check["area"].get<double>(), 4.0, 1e-6);
            // The panes are from 2 to 4 high.
            const bool isMiddle = row.altitude > 0.0;
            EXPECT_NEAR(check["point"][1].get<double>(), isMiddle ? 3.0 : 2.3, 0.02);
            // Nothing stands before the windows: they have the sun that they face.
            std::size_t lit = 0;
            for (const auto& position : found["positions"]) {
                EXPECT_GT(position["altitude"].get<double>(), row.altitude);
                lit += outwards * position["direction"][2].get<double>() > 0.0;
            }
            EXPECT_DOUBLE_EQ(check["hours"].get<double>(), static_cast<double>(lit) / 6.0);
            EXPECT_EQ(check["passes"], check["hours"].get<double>() >= row.threshold);
            EXPECT_EQ(check["lit"].size(), lit > 0 ? 1u : 0u);
        }
        EXPECT_EQ(rule["checks"][0]["passes"], true);
    }
}

TEST_F(SunHoursByRule, SillsRaiseThePointOfEn17037) {
    const Words windows = {"--windows", "glass", "--step", "720", "--sill", "0.5", "--preset"};
    ASSERT_EQ(run(windows + Words{"en17037-minimum"}).status, 0);
    EXPECT_EQ(report()["settings"]["surfaces"]["sill"], 0.5);
    EXPECT_NEAR(report()["rule"]["checks"][0]["point"][1].get<double>(), 2.7, 1e-6);
    const ProcessResult other = run(windows + Words{"din5034-winter"});
    EXPECT_EQ(other.status, 1);
    EXPECT_NE(other.err.find("--sill needs a --preset of EN 17037"), std::string::npos)
        << other.err;
}

TEST_F(SunHoursByRule, WindowsAreNamedByNodeOrMaterial) {
    const auto windows = [&](const Words& more) {
        EXPECT_EQ(
            run(Words{"--date", "2026-03-21", "--step", "720", "--threshold", "0"} + more).status,
            0);
        return report()["rule"]["checks"].size();
    };
    EXPECT_EQ(windows({"--windows", "glass"}), 2u);
    EXPECT_EQ(windows({"--windows", "north window"}), 1u);
    EXPECT_EQ(windows({"--windows", "north window", "--windows", "south window"}), 2u);
    EXPECT_EQ(windows({"--windows", "glass", "--nodes", "south window"}), 1u);
}

TEST_F(SunHoursByRule, GardensPassByHalfOfTheirArea) {
    ASSERT_EQ(run({"--nodes", "garden", "--preset", "bre-garden", "--step", "30"}).status, 0);
    Json rule = report()["rule"];
    EXPECT_EQ(rule["of"], "gardens");
    EXPECT_EQ(rule["needed_area_percent"], 50.0);
    ASSERT_EQ(rule["checks"].size(), 1u);
    EXPECT_EQ(rule["checks"][0]["name"], "garden");
    EXPECT_EQ(rule["passes"], true);
    // In the hours around sunrise the house's own shadow matters little, but there are too few.
    ASSERT_EQ(run({"--nodes", "garden", "--preset", "bre-garden", "--step", "30", "--hours", "5-8"})
                  .status,
              0);
    rule = report()["rule"];
    EXPECT_EQ(rule["passes"], false);
}

TEST_F(SunHoursByRule, ReportsSayVersionAndHashes) {
    ASSERT_EQ(run({"--date", "2026-03-21", "--step", "720"}).status, 0);
    const Json files = report()["files"];
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files[0]["name"], "house.glb");
    EXPECT_EQ(files[0]["sha256"].get<std::string>().size(), 64u);
    const std::string version = runEdgeshade({"--version"}).out;
    EXPECT_EQ("edgeshade " + report()["version"].get<std::string>() + "\n", version);
    // Another byte is another hash; buffers beside the scene have their own.
    const std::string before = files[0]["sha256"];
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1)));
    folder_.write("data.bin", gltf.binary);
    const std::string scene = folder_.write("scene.gltf", gltf.gltf("data.bin"));
    ASSERT_EQ(
        runEdgeshade({"sunhours", scene, folder_ / "a.csv", "--surfaces", "--place", "52.5,13.4",
                      "--date", "2026-03-21", "--step", "720", "--report", folder_ / "report.json"})
            .status,
        0);
    const Json two = report()["files"];
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[1]["name"], "data.bin");
    EXPECT_NE(two[0]["sha256"], two[1]["sha256"]);
    EXPECT_NE(two[0]["sha256"], before);
}

TEST_F(SunHoursByRule, APageTakesTheReportsPlace) {
    ASSERT_EQ(
        run({"--windows", "glass", "--preset", "din5034-winter", "--step", "10"}, "a.html").status,
        0);
    const Bytes bytes = readFile(folder_ / "a.html");
    const std::string page(bytes.begin(), bytes.end());
    for (const char* word : {"DIN 5034-1, winter", "1 of 2 windows pass", "south window",
                             "2026-01-17", "SHA-256", "data:image/png;base64,", "</html>"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST_F(SunHoursByRule, BadUsageIsOneSentence) {
    const Words day = {"--date", "2026-03-21"};
    const auto refuses = [&](const Words& words, const std::string& said) {
        const ProcessResult result = run(words);
        EXPECT_EQ(result.status, 1) << said;
        EXPECT_NE(result.err.find(said), std::string::npos) << said << ": " << result.err;
    };
    refuses(day + Words{"--windows", "door"}, "has no node or material 'door'");
    refuses(day + Words{"--windows", "glass", "--grid", "1"}, "--grid");
    refuses(day + Words{"--windows", "glass", "--nodes", "garden"}, "no surface of that choice");
    refuses({"--windows", "glass", "--preset", "din5034"}, "din5034");
    const ProcessResult page =
        runEdgeshade({"sunhours", folder_.write("house.glb", house()), folder_ / "a.png", "--place",
                      "52.5,13.4", "--date", "2026-03-21", "--report", folder_ / "a.html"});
    EXPECT_EQ(page.status, 1);
    EXPECT_NE(page.err.find("needs --surfaces"), std::string::npos) << page.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

} // namespace edgeshade::test
