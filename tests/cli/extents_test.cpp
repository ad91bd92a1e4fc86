// Lights with an extent, and smooth pictures, in the program: the contents of reports, and
// refusals.
#include "src/image/decode.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace edgeshade::test {
namespace {

using Words = std::vector<std::string>;

class Extents : public testing::Test {
  protected:
    /// A slab above a floor, from the side.
    std::string scene() {
        GltfBuilder gltf;
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1.0f, 0.1f, 1.0f)))},
                      {"translation", {0.0, 1.0, 0.0}}});
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(4.0f, 0.1f, 4.0f)))},
                      {"translation", {0.0, -0.1, 0.0}}});
        return folder_.write("slab.glb", gltf.glb());
    }

    ProcessResult run(const std::string& verb, const Words& more) {
        Words words = {verb, scene()};
        if (verb == "render") words.push_back(folder_ / "out.png");
        for (const char* word :
             {"--size", "96x64", "--camera-from", "3,4,5", "--camera-to", "0,0,0", "--report"})
            words.push_back(word);
        words.push_back(folder_ / "report.json");
        words.insert(words.end(), more.begin(), more.end());
        return runEdgeshade(words);
    }

    Image picture(const Words& more) {
        const ProcessResult result = run("render", more);
        EXPECT_EQ(result.status, 0) << result.err;
        return decodeImage(readFile(folder_ / "out.png"), "out.png");
    }

    Json report() {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }

    void expectUsage(const std::string& verb, const Words& more, const std::string& sentence) {
        const ProcessResult result = run(verb, more);
        EXPECT_EQ(result.status, 1) << result.out;
        EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
    }

    TempFolder folder_;
};

const Words lamp = {"--light", "0.5,4,1.3", "--light-radius", "0.5"};

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::set<int> greysOf(const Image& image) {
    std::set<int> greys;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        if (image.rgba[i + 3] == 255) greys.insert(image.rgba[i]);
    return greys;
}

} // namespace

TEST_F(Extents, AMaskHasTheCountOfPointsInItsGreys) {
    const Image mask = picture(lamp + Words{"--mask", "--light-samples", "5"});
    const std::set<int> greys = greysOf(mask);
    EXPECT_GE(greys.size(), 4u);
    for (const int grey : greys)
        EXPECT_EQ(grey, std::lround(51.0 * std::round(grey / 51.0)));
    EXPECT_TRUE(greys.contains(0));
    EXPECT_TRUE(greys.contains(255));
}

TEST_F(Extents, TheReportListsThePoints) {
    picture(lamp + Words{"--light-samples", "32"});
    const Json points = report()["light_samples"];
    ASSERT_EQ(points.size(), 32u);
    EXPECT_EQ(points[0], Json::parse("[0.5, 4.0, 1.3, 1.0]"));
    for (const Json& point : points)
        EXPECT_LE(std::hypot(point[0].get<double>() - 0.5, point[1].get<double>() - 4.0,
                             point[2].get<double>() - 1.3),
                  0.5);
    picture({"--sun", "1,2,1", "--sun-angle", "4", "--light-samples", "9"});
    EXPECT_EQ(report()["light_samples"].size(), 9u);
    EXPECT_EQ(report()["light_samples"][8][3], 0.0);
    picture({});
    EXPECT_FALSE(report().contains("light_samples"));
}

TEST_F(Extents, PointsReplayedAsHardLightsMakeTheMask) {
    const Image mask = picture(lamp + Words{"--mask", "--light-samples", "6"});
    std::vector<int> sums(mask.rgba.size() / 4);
    const Json points = report()["light_samples"];
    for (const Json& point : points) {
        const std::string place = point[0].dump() + "," + point[1].dump() + "," + point[2].dump();
        const Image one = picture({"--mask", "--light", place});
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += one.rgba[4 * i] != 0;
    }
    std::size_t different = 0; // where an edge crosses a pixel's centre
    for (std::size_t i = 0; i < sums.size(); ++i) {
        EXPECT_NEAR(mask.rgba[4 * i], 255.0 * sums[i] / 6.0, 43.0);
        different += mask.rgba[4 * i] != std::lround(255.0 * sums[i] / 6.0);
    }
    EXPECT_LE(different, 3u);
}

TEST_F(Extents, ARectangleShinesToOneSide) {
    const Words panel = {"--light", "0,0.6,0", "--light-size", "0.3,0.3", "--mask"};
    const std::set<int> down = greysOf(picture(panel));
    const std::set<int> up = greysOf(picture(panel + Words{"--light-direction", "0,1,0"}));
    EXPECT_TRUE(down.contains(255)) << "the floor";
    EXPECT_FALSE(up.contains(255)) << "it is below the slab, which nobody sees from below";
}

TEST_F(Extents, SmoothPicturesAverageShiftedOnes) {
    const Image one = picture({"--smooth", "1"}), plain = picture({}),
                many = picture({"--smooth", "16"});
    EXPECT_EQ(one.rgba, plain.rgba);
    EXPECT_NE(many.rgba, plain.rgba);
    std::size_t apart = 0; // only along outlines
    for (std::size_t i = 0; i < many.rgba.size(); i += 4)
        apart += std::abs(many.rgba[i] - plain.rgba[i]) > 3;
    EXPECT_GT(apart, 50u);
    EXPECT_LT(apart, many.rgba.size() / 4 / 5);
    const Image mask = picture({"--mask", "--smooth", "4"});
    bool partly = false;
    for (std::size_t i = 3; i < mask.rgba.size(); i += 4)
        partly = partly || (mask.rgba[i] != 0 && mask.rgba[i] != 255);
    EXPECT_TRUE(partly) << "outlines";
    for (const int grey : greysOf(mask))
        EXPECT_EQ(grey, std::lround(63.75 * std::round(grey / 63.75)));
}

TEST_F(Extents, CompareCountsPoints) {
    const ProcessResult result =
        run("compare", lamp + Words{"--light-samples", "12", "--against", "light-samples=3",
                                    "--against", "shadows=map,map-size=64"});
    if (result.status == 3) GTEST_SKIP() << "no Embree";
    ASSERT_EQ(result.status, 0) << result.err;
    const Json results = report()["results"];
    ASSERT_EQ(results.size(), 3u);
    EXPECT_LE(results[0]["wrong_points_percent"].get<double>(), 0.05);
    EXPECT_EQ(results[0]["points"].get<int>(), 12 * results[0]["visible_pixels"].get<int>());
    EXPECT_EQ(results[1]["points"].get<int>(), 3 * results[1]["visible_pixels"].get<int>());
    EXPECT_GT(results[2]["wrong_points_percent"].get<double>(), 0.2) << "coarse maps are wrong";
}

TEST_F(Extents, BenchTimesThem) {
    const ProcessResult result = run("bench", lamp + Words{"--frames", "2", "--light-samples", "8",
                                                           "--against", "light-samples=1"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(report()["results"][1]["settings"]["light-samples"], 1);
}

TEST_F(Extents, WhatMeansNothingIsRefused) {
    expectUsage("render", {"--light-samples", "8"}, "--light-samples needs a light with an extent");
    expectUsage("render", {"--shade-samples"}, "--shade-samples needs a light with an extent");
    expectUsage("render", {"--sun", "0,1,0", "--light-radius", "1"},
                "--light-radius is of point lights");
    expectUsage("render", {"--light", "0,1,0", "--sun-angle", "1"},
                "--sun-angle is of directional lights");
    expectUsage("render", lamp + Words{"--light-size", "1,1"}, "--light-size");
    expectUsage("render", {"--light-direction", "0,1,0"}, "--light-direction");
    expectUsage("render", lamp + Words{"--samples", "4"}, "--smooth does");
    expectUsage("render", lamp + Words{"--debug", "volumes"}, "--debug volumes");
    expectUsage("render", lamp + Words{"--mask", "--light-samples", "4096", "--smooth", "17"},
                "65535");
    expectUsage("render", lamp + Words{"--shade-samples", "--light-samples", "257"}, "at most 256");
    expectUsage("render", lamp + Words{"--shade-samples", "--shading", "base"}, "--shading full");
    expectUsage("bench", {"--light-samples", "8"}, "needs a light with an extent");
    expectUsage("compare", {"--light-samples", "8"}, "needs a light with an extent");
    for (const Words& wrong :
         {Words{"--light", "0,1,0", "--light-radius", "0"},
          Words{"--light", "0,1,0", "--light-radius", "x"},
          Words{"--light", "0,1,0", "--light-size", "1"},
          Words{"--light", "0,1,0", "--light-size", "1,-1"}, Words{"--sun-angle", "0"},
          Words{"--sun-angle", "91"}, Words{"--smooth", "0"}, Words{"--smooth", "257"},
          lamp + Words{"--light-samples", "0"}, lamp + Words{"--light-samples", "4097"}})
        EXPECT_EQ(run("render", wrong).status, 1) << wrong.back();
}

} // namespace edgeshade::test
