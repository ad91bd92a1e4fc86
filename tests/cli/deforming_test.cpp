// Moving skins and morph targets, against rays: render, compare and bench at a time of an
// animation.
#include "tests/support/moving_scenes.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

class Deforming : public testing::Test {
  protected:
    ProcessResult run(const std::string& verb, const std::string& file,
                      std::vector<std::string> more) {
        std::vector<std::string> arguments = {verb, file};
        if (verb == "render") arguments.push_back(folder_ / "out.png");
        more.insert(more.end(), {"--size", "160x120", "--report", folder_ / "report.json"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }
    Bytes picture(const std::string& file, std::vector<std::string> more) {
        more.insert(more.end(), {"--camera-from", "3,2,4", "--camera-to", "0,0.9,0"});
        const ProcessResult result = run("render", file, more);
        EXPECT_EQ(result.status, 0) << result.err;
        return readFile(folder_ / "out.png");
    }
    Json report() const {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }

    /// Three views at each time: no pixel is wrong farther than a pixel from an edge, ties apart.
    void expectMasksOfRays(const std::string& file, const std::string& animation,
                           std::vector<std::string> more = {},
                           const std::vector<std::string>& times = {"0", "0.31", "1.1"}) {
        for (const std::string& time : times) {
            std::vector<std::string> words = {"--time",  time,      "--animation",
                                              animation, "--views", "3"};
            words.insert(words.end(), more.begin(), more.end());
            const ProcessResult result = run("compare", file, words);
            ASSERT_EQ(result.status, 0) << result.err;
            EXPECT_EQ(report()["wrong_image_beyond_1px_not_tied"], 0) << animation << " " << time;
            EXPECT_LT(report()["wrong_mask_pixels"].get<int>(), 12) << animation << " " << time;
        }
    }

    TempFolder folder_;
    std::string figure_ = folder_.write("figure.glb", walkingFigure(10, 12).glb());
    std::string ball_ = folder_.write("ball.glb", morphingBall(16, 16).glb());
};

using LongDeforming = Deforming;

} // namespace

TEST_F(Deforming, ASkinsMasksAreThoseOfRays) {
    expectMasksOfRays(figure_, "walk");
}

TEST_F(Deforming, AMorphsMasksAreThoseOfRays) {
    expectMasksOfRays(ball_, "morph");
}

TEST_F(Deforming, SplinesAndStepsToo) {
    expectMasksOfRays(figure_, "wave", {"--shadows", "primitive-map"});
    expectMasksOfRays(ball_, "splines");
}

TEST_F(LongDeforming, MasksOfManyTimesAreThoseOfRays) {
    const std::vector<std::string> times = {"0.13", "0.5", "0.62", "0.77", "0.9", "1.4", "1.9"};
    expectMasksOfRays(figure_, "walk", {}, times);
    expectMasksOfRays(ball_, "morph", {}, times);
    expectMasksOfRays(figure_, "wave", {"--shadows", "primitive-map"}, times);
    expectMasksOfRays(ball_, "splines", {}, times);
}

TEST_F(Deforming, OnAnyLayoutOfRecords) {
    for (const std::string layout : {"published", "adapted"})
        for (const std::string instancing : {"on", "off"}) {
            const ProcessResult result = run(
                "compare", figure_,
                {"--time", "0.3", "--views", "4", "--layout", layout, "--instancing", instancing});
            ASSERT_EQ(result.status, 0) << result.err;
            EXPECT_EQ(report()["wrong_image_beyond_1px_not_tied"], 0) << layout;
        }
}

TEST_F(Deforming, ThePackedFileMovesAlike) {
    for (const std::string encoding : {"none", "indexed", "expanded"}) {
        const std::string packed = folder_ / "packed.glb";
        ASSERT_EQ(runEdgeshade({"pack", figure_, packed, "--encoding", encoding}).status, 0);
        const std::vector<std::string> words = {"--time", "0.3", "--animation", "walk"};
        EXPECT_EQ(picture(packed, words), picture(figure_, words)) << encoding;
        std::vector<std::string> published = words;
        published.insert(published.end(), {"--layout", "published"});
        EXPECT_EQ(picture(packed, published), picture(figure_, published)) << encoding;
    }
}

TEST_F(Deforming, AnimationsAreChosenByNameOrIndex) {
    const Bytes walk = picture(figure_, {"--time", "0.4", "--animation", "walk"});
    EXPECT_EQ(report()["settings"]["animation"], "walk");
    EXPECT_EQ(picture(figure_, {"--time", "0.4"}), walk) << "the first";
    EXPECT_EQ(picture(figure_, {"--time", "0.4", "--animation", "0"}), walk);
    const Bytes wave = picture(figure_, {"--time", "0.4", "--animation", "wave"});
    EXPECT_NE(wave, walk);
    EXPECT_EQ(picture(figure_, {"--animation", "jump"}),
              picture(figure_, {"--animation", "jump", "--time", "0.1"}))
        << "a step has not come yet";
    EXPECT_NE(picture(figure_, {"--animation", "jump", "--time", "0.6"}),
              picture(figure_, {"--animation", "jump", "--time", "0.4"}));
}

TEST_F(Deforming, AnAnimationThatThereIsNotIsWarnedOf) {
    const Bytes rest = picture(figure_, {});
    const ProcessResult result = run("render", figure_, {"--animation", "swim"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("no animation 'swim'; it has 0 'walk', 1 'wave', 2 'jump'"),
              std::string::npos)
        << result.err;
    EXPECT_NE(run("render", figure_, {"--time", "1"}).err.find("the first, 'walk', is shown"),
              std::string::npos);
    ASSERT_EQ(runEdgeshade({"info", figure_, "--report", folder_ / "report.json"}).status, 0);
    EXPECT_EQ(report()["animations"], Json::parse(R"([{"index": 0, "name": "walk"},
        {"index": 1, "name": "wave"}, {"index": 2, "name": "jump"}])"));
}

TEST_F(Deforming, BenchTakesAPose) {
    ASSERT_EQ(
        run("bench", figure_, {"--time", "0.2", "--animation", "walk", "--frames", "2"}).status, 0);
    EXPECT_EQ(report()["settings"]["animation"], "walk");
}

} // namespace edgeshade::test
