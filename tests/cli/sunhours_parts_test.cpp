// sunhours --surfaces --part: merged parts give the bytes of a whole run; what doesn't fit is
// refused.
#include "tests/support/blocks.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/weather.hpp"
#include "tests/support/words.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

class SunHoursOfSurfacesInParts : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult result =
            runEdgeshade(Words{"sunhours", scene_, folder_ / "a.csv"} + equinox);
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
    }

    /// Writes parts 1 to `of`; returns their paths, the last one first.
    Words parts(std::size_t of, const Words& options) {
        Words paths;
        for (std::size_t k = of; k >= 1; --k) {
            paths.push_back(folder_ / ("part " + std::to_string(k)));
            const ProcessResult result =
                runEdgeshade(Words{"sunhours", scene_, paths.back(), "--part",
                                   std::to_string(k) + "/" + std::to_string(of)} +
                             options);
            EXPECT_EQ(result.status, 0) << result.err;
            EXPECT_NE(result.out.find("part " + std::to_string(k)), std::string::npos);
        }
        return paths;
    }

    /// Files and report of the whole run, and of parts, are the same.
    void expectSame(std::size_t of, const Words& options, const Words& ends,
                    const std::string& report, const Words& words = {}) {
        const auto written = [&](const std::string& start) {
            Words paths;
            for (const std::string& end : ends)
                paths.push_back(folder_ / (start + end));
            return paths;
        };
        const auto more = [&](const std::string& start) {
            return Words{"--report", folder_ / (start + report)} + words;
        };
        const ProcessResult whole =
            runEdgeshade(Words{"sunhours", scene_} + written("whole") + more("whole") + options);
        ASSERT_EQ(whole.status, 0) << whole.err;
        const Words paths = parts(of, options);
        const ProcessResult merged =
            runEdgeshade(Words{"sunhours-merge"} + written("merged") + paths + more("merged"));
        ASSERT_EQ(merged.status, 0) << merged.err;
        for (const std::string& end : ends + Words{report})
            EXPECT_EQ(readFile(folder_ / ("merged" + end)), readFile(folder_ / ("whole" + end)))
                << end;
        // The line about the run names the first file, and says the same.
        EXPECT_EQ(merged.out.substr(merged.out.find(": ")), whole.out.substr(whole.out.find(": ")));
    }

    void refuses(const Words& words, int status, const std::string& said) const {
        const ProcessResult result = runEdgeshade(words);
        EXPECT_EQ(result.status, status) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << said << ": " << result.err;
        EXPECT_EQ(result.err.find("edgeshade: "), result.err.rfind("edgeshade: ")) << result.err;
    }

    /// A copy of a part's file with other JSON.
    template <class Change>
    std::string changed(const std::string& path, const Change& change) {
        const Bytes bytes = readFile(path);
        Json json = Json::parse(bytes.begin(), bytes.end());
        change(json);
        const std::string text = json.dump();
        return folder_.write("changed", Bytes(text.begin(), text.end()));
    }

    const TempFolder folder_;
    const std::string scene_ = folder_.write(
        "scene.glb", blocksOnALawn({{{-1.5, 0, -1}, {1.25, 3, 1}}, {{3, 0, -2}, {4, 2, 2}}}));
    const Words surfaces = {"--surfaces", "--grid", "2", "--step", "60"};
    const Words place = {"--place", "48.14,11.57", "--utc-offset", "+01:00"};
    const Words equinox = surfaces + place + Words{"--date", "2026-03-21"};
};

} // namespace

TEST_F(SunHoursOfSurfacesInParts, AreTheWholeByteForByte) {
    // Twelve positions: of 17 parts five have none.
    for (const std::size_t of : {1u, 3u, 17u})
        expectSame(of, equinox + Words{"--threshold", "2"}, {".glb", ".csv", ".npy"}, ".json",
                   {"--when"});
    expectSame(2, equinox + Words{"--nodes", "block 1"}, {".csv"}, ".html");
    expectSame(2, surfaces + place + Words{"--date", "2026-06-21", "--hours", "0-3"}, {".glb"},
               ".json"); // the sun is down
}

TEST_F(SunHoursOfSurfacesInParts, SumEnergyByWeatherAndMonths) {
    const Words year = {"--epw",  folder_.write("station.epw", WeatherText().text()),
                        "--from", "2026-01-01",
                        "--to",   "2026-12-31"};
    expectSame(4, surfaces + year + Words{"--quantity", "direct-kwh"}, {".csv", ".glb"}, ".json");
}

TEST_F(SunHoursOfSurfacesInParts, JudgeWindows) {
    expectSame(
        3,
        Words{"--surfaces", "--windows", "block 1", "--preset", "din5034-equinox", "--step", "20"} +
            place,
        {".csv"}, ".html");
}

TEST_F(SunHoursOfSurfacesInParts, WantsPartsOfOneRun) {
    const Words good = parts(2, equinox);
    const std::string out = folder_ / "bad.csv";
    const auto refusesParts = [&](const Words& paths, const std::string& said) {
        refuses(Words{"sunhours-merge", out} + paths, 2, said);
        EXPECT_FALSE(std::filesystem::exists(out));
    };
    refusesParts({good[1]}, "parts is 2, but part 2 is missing");
    refusesParts(good + Words{good[0]}, "already has that number");

    const auto second = [&](const std::string& scene, const Words& options) {
        const std::string path = folder_ / "other part";
        const ProcessResult result =
            runEdgeshade(Words{"sunhours", scene, path, "--part", "2/2"} + options);
        EXPECT_EQ(result.status, 0) << result.err;
        return path;
    };
    const TempFolder other;
    refusesParts({good[1], second(other.write("scene.glb", blocksOnALawn({})), equinox)},
                 "scene is \"");
    refusesParts({good[1], second(scene_, equinox + Words{"--offset", "0.1"})},
                 "settings.surfaces.offset is 0.1");
    refusesParts({good[1], changed(good[0], [](Json& json) { json["version"] = "0.0.1"; })},
                 "version is \"0.0.1\"");
    refusesParts({folder_ / "scene.glb.part"}, "does not exist");

    // Parts of a picture, and files that parts don't make.
    const std::string picture = folder_ / "picture part";
    ASSERT_EQ(runEdgeshade(Words{"sunhours", scene_, picture, "--part", "1/2", "--size", "20x20",
                                 "--by", "rays", "--date", "2026-03-21"} +
                           place)
                  .status,
              0);
    refusesParts({picture, good[0]}, "'" + picture + "' is not a part of --surfaces");
    refuses(Words{"sunhours-merge", folder_ / "bad.png"} + good, 2, "is a part of --surfaces");
    refuses(Words{"sunhours-merge", out, "--counts", folder_ / "c.png"} + good, 1, "--counts");
    refuses(Words{"sunhours-merge", folder_ / "bad.png", picture, "--when"}, 1, "--when");
    refuses({"sunhours-merge", out, folder_ / "bad.glb"}, 1, "needs the parts of a run");
    const Words part = Words{"--part", "1/2"} + equinox;
    refuses(Words{"sunhours", scene_, out} + part, 1, "can't end in .glb");
    refuses(Words{"sunhours", scene_, folder_ / "1", folder_ / "2"} + part, 1,
            "a part is one file");
    refuses(Words{"sunhours", scene_, folder_ / "1", "--part", "1/1", "--surfaces", "--grid",
                  "0.04", "--from", "2026-01-01", "--to", "2026-12-31"} +
                place,
            1, "would exceed 1 GiB; take more parts");
    refuses(Words{"sunhours", scene_, folder_ / "1", "--when"} + part, 1, "--when");
    refuses(Words{"sunhours", scene_, folder_ / "1", "--report", "r.json"} + part, 1, "--report");
}

} // namespace edgeshade::test
