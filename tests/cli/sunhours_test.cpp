// sunhours and sunhours-merge: hours derived from geometry, splitting, bad usage.
#include "tests/support/blocks.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/words.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <stb_image.h>
#include <thread>

namespace edgeshade::test {
namespace {

/// 16-bit grey and alpha.
struct Counts {
    int width = 0, height = 0;
    std::vector<std::uint16_t> pixels;

    std::uint16_t litAt(int x, int y) const { return pixels[2 * index(x, y)]; }
    std::uint16_t alphaAt(int x, int y) const { return pixels[2 * index(x, y) + 1]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

class SunHours : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult result =
            runEdgeshade(Words{"sunhours", lawn(), folder_ / "try.png"} + equinox +
                         Words{"--size", "8x8", "--step", "720"});
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
    }

    /// A floor of 16 x 16 at 0, facing up.
    std::string lawn() { return withBlocks("lawn.glb", {}); }

    /// The same floor with boxes on it.
    std::string withBlocks(const std::string& name, const std::vector<Block>& blocks) {
        return folder_.write(name, blocksOnALawn(blocks));
    }

    ProcessResult run(const std::string& scene, const Words& more) {
        return runEdgeshade(Words{"sunhours", scene, folder_ / "out.png", "--report",
                                  folder_ / "report.json", "--counts", folder_ / "counts.png"} +
                            equinox + more);
    }

    Json report(const std::string& name = "report.json") {
        const Bytes bytes = readFile(folder_ / name);
        return Json::parse(bytes.begin(), bytes.end());
    }

    Counts counts() {
        const Bytes png = readFile(folder_ / "counts.png");
        Counts read;
        int channels = 0;
        const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
            stbi_load_16_from_memory(png.data(), static_cast<int>(png.size()), &read.width,
                                     &read.height, &channels, 0),
            stbi_image_free);
        EXPECT_TRUE(pixels);
        EXPECT_EQ(channels, 2);
        read.pixels.assign(pixels.get(), pixels.get() + 2 * read.width * read.height);
        return read;
    }

    /// Directions towards the sun of all positions.
    std::vector<glm::dvec3> directions() {
        std::vector<glm::dvec3> found;
        const Json all = report();
        for (const auto& position : all["positions"])
            found.emplace_back(position["direction"][0].get<double>(),
                               position["direction"][1].get<double>(),
                               position["direction"][2].get<double>());
        return found;
    }

    /// Each pixel of the floor, seen from above at 10 pixels per unit, counts the positions whose
    /// rays miss the blocks; those that barely touch one may count or not.
    void expectHoursByHand(const std::vector<Block>& blocks) {
        const Counts drawn = counts();
        const std::vector<glm::dvec3> suns = directions();
        ASSERT_EQ(drawn.width, 160);
        std::size_t checked = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) {
                const glm::dvec3 point((x + 0.5) / 10.0 - 8.0, 0.0, (y + 0.5) / 10.0 - 8.0);
                const bool isRoof = std::ranges::any_of(blocks, [&](const Block& block) {
                    return block.low.x < point.x && point.x < block.high.x &&
                           block.low.z < point.z && point.z < block.high.z;
                });
                if (isRoof) continue;
                const auto litAround = [&](double margin) {
                    return std::ranges::count_if(suns, [&](const glm::dvec3& sun) {
                        return std::ranges::none_of(blocks, [&](const Block& block) {
                            return block.blocks(point, sun, margin);
                        });
                    });
                };
                ++checked;
                EXPECT_GE(drawn.litAt(x, y), litAround(1e-4)) << x << " " << y;
                EXPECT_LE(drawn.litAt(x, y), litAround(-1e-4)) << x << " " << y;
                EXPECT_EQ(drawn.alphaAt(x, y), 65535);
            }
        EXPECT_GT(checked, 15000u);
    }

    /// From straight above, -Z up, 10 pixels per unit.
    const Words fromAbove = {"--size", "160x160",         "--ortho",
                             "16",     "--camera-matrix", "1,0,0,0,0,0,1,0,0,-1,0,0,0,0,-20,1"};
    const Words equinox = {"--place", "48.14,11.57", "--date", "2026-03-21"};
    const TempFolder folder_;
};

} // namespace

TEST_F(SunHours, OfABoxOnAPlaneAreThoseWorkedOutByHand) {
    const std::vector<Block> blocks = {{{-0.5, 0.0, -0.5}, {0.5, 3.0, 0.5}}};
    const std::string scene = withBlocks("box.glb", blocks);
    for (const char* way : {"rays", "masks"})
        for (const char* north : {"0", "35"}) {
            ASSERT_EQ(run(scene, fromAbove + Words{"--north", north, "--by", way}).status, 0);
            EXPECT_EQ(report()["settings"]["by"], way);
            expectHoursByHand(blocks);
        }
}

TEST_F(SunHours, OfAStreetCanyonAreThoseWorkedOutByHand) {
    // A street of two rows of houses, and a bridge across it.
    const std::vector<Block> houses = {
        {{-4, 0, -7}, {-2, 5, 7}}, {{2, 0, -7}, {4, 3, 7}}, {{-2, 2.5, -0.27}, {2, 3, 0.27}}};
    const std::string scene = withBlocks("street.glb", houses);
    for (const char* way : {"rays", "masks"}) {
        ASSERT_EQ(run(scene, fromAbove + Words{"--north", "20", "--step", "5", "--by", way}).status,
                  0);
        expectHoursByHand(houses);
    }
}

TEST_F(SunHours, SayHowTheyAreCountedAndWhy) {
    const std::string scene = withBlocks("box.glb", {{{-0.5, 0, -0.5}, {0.5, 3, 0.5}}});
    const auto way = [&](const Words& more) {
        const ProcessResult result = run(scene, Words{"--size", "60x40", "--step", "60"} + more);
        EXPECT_EQ(result.status, 0) << result.err;
        const Json settings = report()["settings"];
        return settings["by"].get<std::string>() + ", " + settings["by-reason"].get<std::string>();
    };
    EXPECT_EQ(way({"--by", "rays"}), "rays, --by");
    EXPECT_EQ(way({"--by", "masks"}), "masks, --by");
    EXPECT_EQ(way({"--caster-error", "0.01"}), "masks, --caster-error");
    EXPECT_EQ(way({"--gl-limits", "es2-minimum"}), "masks, --gl-limits");
    EXPECT_EQ(way({"--cast-cutouts"}), "rays, masks count no cutouts");
    const std::string automatic = way({});
    EXPECT_TRUE(automatic == "rays, the processor draws" || automatic == "masks, hardware draws")
        << automatic;
}

// A section through a box lets the sun into it; its walls still shade.
TEST_F(SunHours, OfCutScenesAreCountedByRaysAsByMasks) {
    const std::string scene = withBlocks("box.glb", {{{-2, 0, -2}, {2, 3, 2}}});
    for (const char* shadows : {"cut", "whole"}) {
        std::array<double, 2> mean{};
        std::array<Json, 2> found;
        for (std::size_t i = 0; i < 2; ++i) {
            ASSERT_EQ(
                run(scene, Words{"--size", "150x100", "--step", "60", "--section", "0,-1,0,1.5",
                                 "--section-shadows", shadows, "--by", i == 0 ? "rays" : "masks"})
                    .status,
                0);
            found[i] = report();
            mean[i] = found[i]["hours"]["mean"].get<double>();
        }
        EXPECT_NEAR(mean[0], mean[1], 0.01);
        ASSERT_EQ(found[0]["by_node"].size(), 3u); // with the cut face
        for (std::size_t n = 0; n < 3; ++n)
            EXPECT_EQ(found[0]["by_node"][n]["name"], found[1]["by_node"][n]["name"]);
    }
}

TEST_F(SunHours, OfACourtyardAreThoseWorkedOutByHand) {
    // Walls of 2 around a court of 6 x 6.
    const std::vector<Block> walls = {{{-4, 0, -4}, {4, 2, -3}},
                                      {{-4, 0, 3}, {4, 2, 4}},
                                      {{-4, 0, -3}, {-3, 2, 3}},
                                      {{3, 0, -3}, {4, 2, 3}}};
    const std::string scene = withBlocks("court.glb", walls);
    for (const char* way : {"masks", "rays"}) {
        ASSERT_EQ(
            run(scene, fromAbove + Words{"--at", "0,0,0,0,1,0", "--at", "0,2,3.5", "--by", way})
                .status,
            0);
        expectHoursByHand(walls);
    }

    // The court's middle sees the sun above the wall: over 3 / max(|sin|, |cos|) of ground.
    std::size_t above = 0;
    const Json all = report();
    for (const auto& position : all["positions"]) {
        const double azimuth = glm::radians(position["azimuth"].get<double>());
        const double altitude = glm::radians(position["altitude"].get<double>());
        const double ground =
            3.0 / std::max(std::abs(std::sin(azimuth)), std::abs(std::cos(azimuth)));
        above += std::tan(altitude) * ground > 2.0;
    }
    const Json probes = report()["probes"];
    ASSERT_EQ(probes.size(), 2u);
    EXPECT_DOUBLE_EQ(probes[0]["hours"].get<double>(), static_cast<double>(above) / 6.0);
    EXPECT_GT(above, 10u);
    EXPECT_LT(above, 60u);
    EXPECT_EQ(probes[0]["normal"], (Json{0.0, 1.0, 0.0}));
    // On top of the wall nothing blocks the sun.
    EXPECT_DOUBLE_EQ(probes[1]["hours"].get<double>(), report()["possible_hours"].get<double>());
    ASSERT_EQ(probes[1]["lit"].size(), 1u);
    EXPECT_EQ(probes[1]["lit"][0][0], "2026-03-21T06:20+01:00");
}

TEST_F(SunHours, WeighByTrueArea) {
    // From straight above, only the roof of a block is visible, and the rest of the lawn.
    const std::string scene = withBlocks("box.glb", {{{-2, 0, -2}, {2, 1, 2}}});
    for (const Words& camera : {fromAbove, Words{"--size", "300x300", "--camera-from", "0,40,0.001",
                                                 "--camera-to", "0,0,0", "--fov", "30"}}) {
        ASSERT_EQ(run(scene, camera + Words{"--step", "60", "--threshold", "2"}).status, 0);
        const Json found = report();
        ASSERT_EQ(found["by_node"].size(), 2u);
        EXPECT_EQ(found["by_node"][0]["name"], "lawn");
        EXPECT_EQ(found["by_node"][1]["name"], "block 1");
        EXPECT_NEAR(found["by_node"][1]["area"].get<double>(), 16.0, 0.4);
        EXPECT_NEAR(found["by_node"][0]["area"].get<double>(), 256.0 - 16.0, 4.0);
        EXPECT_DOUBLE_EQ(found["by_node"][1]["hours"]["min"].get<double>(),
                         found["possible_hours"].get<double>());
        ASSERT_EQ(found["by_material"].size(), 1u);
        double area = 0.0;
        for (const auto& bin : found["histogram"])
            area += bin["area"].get<double>();
        EXPECT_NEAR(area, found["area"].get<double>(), 1e-6 * area);
    }
}

TEST_F(SunHours, OfAFreeLawnAreAllOfTheDay) {
    ASSERT_EQ(run(lawn(), {"--plan", "--size", "64x48", "--preset", "bre-garden"}).status, 0);
    const Json found = report();
    EXPECT_EQ(found["hours"]["min"], found["possible_hours"]);
    EXPECT_EQ(found["area_above_threshold_percent"], 100.0);
    EXPECT_EQ(found["half_of_area"], true);
    EXPECT_NEAR(found["area"].get<double>(), 256.0, 6.0);
    EXPECT_EQ(found["settings"]["threshold"], 2.0);
    EXPECT_EQ(counts().alphaAt(0, 0), 0);
    EXPECT_EQ(counts().litAt(0, 0), 0);
    EXPECT_EQ(counts().litAt(32, 24), found["positions"].size());
}

TEST_F(SunHours, InThePolarNightAreNone) {
    const ProcessResult result = runEdgeshade(
        {"sunhours", lawn(), folder_ / "out.png", "--report", folder_ / "report.json", "--place",
         "78.2,15.6", "--date", "2026-12-21", "--size", "32x32", "--plan", "--at", "0,0,0"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("warning: The sun is never higher"), std::string::npos);
    EXPECT_EQ(report()["positions"].size(), 0u);
    EXPECT_EQ(report()["hours"]["max"], 0.0);
    EXPECT_GT(report()["area"].get<double>(), 200.0);
    EXPECT_EQ(report()["probes"][0]["lit"].size(), 0u);
}

TEST_F(SunHours, ThePresetHasADateAndSaysWhenItDoesNotFit) {
    ASSERT_EQ(runEdgeshade({"sunhours", lawn(), folder_ / "out.png", "--report",
                            folder_ / "report.json", "--place", "48,11", "--preset",
                            "en17037-medium", "--size", "16x16", "--step", "60"})
                  .status,
              0);
    EXPECT_EQ(report()["settings"]["from"], "2026-03-21");
    EXPECT_EQ(report()["settings"]["threshold"], 3.0);
    EXPECT_FALSE(report().contains("half_of_area"));
    const ProcessResult june =
        runEdgeshade({"sunhours", lawn(), folder_ / "out.png", "--place", "48,11", "--preset",
                      "en17037-high", "--date", "2026-06-21", "--size", "16x16", "--step", "60"});
    EXPECT_EQ(june.status, 0);
    EXPECT_NE(june.err.find("warning: --preset en17037-high is for a day from 02-01 to 03-21"),
              std::string::npos)
        << june.err;
    EXPECT_NE(june.err.find("UTC+01:00, by the longitude"), std::string::npos);
}

TEST_F(SunHours, PartsBecomeTheWholeByteForByte) {
    const std::string scene = withBlocks("box.glb", {{{-0.5, 0, -0.5}, {0.5, 3, 0.5}}});
    const Words settings = equinox + Words{"--size", "90x70",       "--threshold", "4",
                                           "--at",   "0,0,2,0,1,0", "--from",      "2026-03-20",
                                           "--to",   "2026-03-22",  "--step",      "60"};
    Words days = settings; // --from and --to in place of --date
    days.erase(days.begin() + 2, days.begin() + 4);
    ASSERT_EQ(runEdgeshade(Words{"sunhours", scene, folder_ / "out.png", "--report",
                                 folder_ / "report.json", "--counts", folder_ / "counts.png"} +
                           days)
                  .status,
              0);
    Words parts;
    for (const char* part : {"3/5", "1/5", "5/5", "2/5", "4/5"}) {
        parts.push_back(folder_ / ("part" + std::string(part, 1)));
        const ProcessResult result =
            runEdgeshade(Words{"sunhours", scene, parts.back(), "--part", part} + days);
        ASSERT_EQ(result.status, 0) << result.err;
    }
    const Words merge = {"sunhours-merge",   folder_ / "m.png", "--report",
                         folder_ / "m.json", "--counts",        folder_ / "mc.png"};
    ASSERT_EQ(runEdgeshade(merge + parts).status, 0);
    EXPECT_EQ(readFile(folder_ / "m.png"), readFile(folder_ / "out.png"));
    EXPECT_EQ(readFile(folder_ / "mc.png"), readFile(folder_ / "counts.png"));
    EXPECT_EQ(readFile(folder_ / "m.json"), readFile(folder_ / "report.json"));
    EXPECT_EQ(report()["days"], 3);

    // A part of another scene, one counted another way, a missing part, an invalid one.
    const TempFolder other;
    ASSERT_EQ(
        runEdgeshade(Words{"sunhours", lawn(), other / "part3", "--part", "3/5"} + days).status, 0);
    const auto refuses = [&](Words bad, const std::string& word) {
        const ProcessResult result = runEdgeshade(Words{"sunhours-merge", other / "bad.png"} + bad);
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(other / "bad.png"));
    };
    Words mixed = parts;
    mixed[0] = other / "part3";
    refuses(mixed, "not parts of one run");
    const std::string otherWay = report()["settings"]["by"] == "rays" ? "masks" : "rays";
    ASSERT_EQ(
        runEdgeshade(Words{"sunhours", scene, other / "part1", "--part", "1/5", "--by", otherWay} +
                     days)
            .status,
        0);
    mixed[0] = parts[0];
    mixed[1] = other / "part1";
    refuses(mixed, "settings.by");
    refuses(Words(parts.begin() + 1, parts.end()), "part 3 is missing");
    refuses(parts + Words{parts[1]}, "already");
    refuses({folder_ / "out.png"}, "not a part of a sunhours run");
    refuses({folder_ / "nothing"}, "nothing");
}

TEST_F(SunHours, BadUsageIsOneSentence) {
    struct Row {
        Words words;
        std::string said;
    };
    const Row rows[] = {
        {{"--date", "2026-03-21"}, "--place"},
        {{"--place", "48,11"}, "--date"},
        {{"--place", "91,11", "--date", "2026-03-21"}, "91"},
        {{"--place", "48,11", "--date", "2026-02-29"}, "no day 29"},
        {{"--place", "48,11", "--date", "yesterday"}, "is not a valid date"},
        {{"--place", "48,11", "--from", "2026-03-21"}, "--to"},
        {{"--place", "48,11", "--from", "2026-03-21", "--to", "2026-03-20"}, "before --from"},
        {{"--place", "48,11", "--date", "2026-03-21", "--from", "2026-03-21", "--to", "2026-03-22"},
         "excludes"},
        {equinox + Words{"--step", "7"}, "7 does not divide"},
        {equinox + Words{"--step", "0.5"}, "--step"},
        {equinox + Words{"--hours", "17-9"}, "17-9"},
        {equinox + Words{"--hours", "9"}, "--hours"},
        {equinox + Words{"--hours", "9-25"}, "9-25"},
        {equinox + Words{"--hours", ""}, "--hours"},
        {equinox + Words{"--utc-offset", "2"}, "not a valid offset from UTC"},
        {equinox + Words{"--min-altitude", "-1"}, "--min-altitude"},
        {equinox + Words{"--threshold", "25"}, "--threshold"},
        {equinox + Words{"--preset", "leed"}, "leed"},
        {equinox + Words{"--preset", "bre-garden", "--threshold", "2"}, "excludes"},
        {equinox + Words{"--plan", "--ortho", "5"}, "--ortho"},
        {equinox + Words{"--at", "1,2"}, "--at"},
        {equinox + Words{"--at", "1,2,3,0,0,0"}, "normal"},
        {equinox + Words{"--part", "4/3"}, "4/3"},
        {equinox + Words{"--part", "0/3"}, "0/3"},
        {equinox + Words{"--part", "1/2", "--counts", "c.png"}, "--counts"},
        {equinox + Words{"--sun", "0,1,0"}, "--sun"},
        {equinox + Words{"--by", "light"}, "light"},
        {equinox + Words{"--by", "masks", "--cast-cutouts"}, "--cast-cutouts"},
        {equinox + Words{"--by", "rays", "--caster-error", "1"}, "--caster-error"},
        {equinox + Words{"--by", "rays", "--weld-tolerance", "auto"}, "--weld-tolerance"},
        {equinox + Words{"--by", "rays", "--flat-tolerance", "1"}, "--flat-tolerance"},
        {equinox + Words{"--by", "rays", "--gl-limits", "es2-minimum"}, "--gl-limits"},
        {{"--place", "48,11", "--from", "2000-01-01", "--to", "2026-12-31"}, "65535"},
    };
    for (const Row& row : rows) {
        const ProcessResult result =
            runEdgeshade(Words{"sunhours", lawn(), folder_ / "bad.png"} + row.words);
        EXPECT_EQ(result.status, 1) << row.said << ": " << result.err;
        EXPECT_NE(result.err.find(row.said), std::string::npos) << row.said << ": " << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.png"));
    }
    const ProcessResult unwritable = runEdgeshade(
        Words{"sunhours", lawn(), "/nowhere/out.png", "--size", "8x8", "--step", "720"} + equinox);
    EXPECT_EQ(unwritable.status, 4);
}

TEST_F(SunHours, InterruptedLeavesNoPartialFile) {
    for (const int delay : {20, 200, 600, 1200}) {
        const TempFolder folder;
        ChildProcess process(EDGESHADE_PROGRAM,
                             Words{"sunhours", std::string(EDGESHADE_ASSETS) + "/pavilion.glb",
                                   folder / "out.png", "--size", "1920x1080", "--step", "1", "--by",
                                   delay == 600 ? "masks" : "rays", "--report",
                                   folder / "report.json"} +
                                 equinox);
        std::this_thread::sleep_for(std::chrono::milliseconds(delay));
        process.send(SIGINT);
        const ProcessResult result = process.wait();
        EXPECT_EQ(result.signal, SIGINT);
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST_F(SunHours, ALogHasALineAStage) {
    const ProcessResult result = run(lawn(), Words{"--size", "64x64", "--step", "10", "--at",
                                                   "1,1,1", "--utc-offset", "+01:00"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err.find_first_of("\r\033"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("progress: counting"), std::string::npos) << result.err;
    EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 3) << result.err;
}

TEST_F(SunHours, HelpNamesTheOptions) {
    const ProcessResult help = runEdgeshade({"sunhours", "--help-all"});
    for (const char* word :
         {"--place", "--date", "--from", "--to", "--step", "--hours", "--utc-offset",
          "--min-altitude", "--north", "--plan", "--counts", "--report", "--at", "--threshold",
          "--preset", "--part", "--by", "--camera", "--size"})
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
    EXPECT_EQ(help.out.find("--light "), std::string::npos);
    const ProcessResult merge = runEdgeshade({"sunhours-merge", "--help"});
    for (const char* word : {"OUT", "PARTS", "--counts", "--report"})
        EXPECT_NE(merge.out.find(word), std::string::npos) << word;
}

} // namespace edgeshade::test
