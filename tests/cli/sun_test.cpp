// The sun by --place, --time-of-day and --north.
#include "src/image/decode.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using Words = std::vector<std::string>;

const Words noon = {"--place", "48.14,11.57", "--time-of-day", "2026-06-21T14:30+02:00"};
const Words night = {"--place", "48.14,11.57", "--time-of-day", "2026-06-21T01:00+02:00"};
const Words lateAutumn = {"--place", "-33.87,151.21", "--time-of-day", "2026-05-21T10:00+10:00"};

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

class SunByPlace : public testing::Test {
  protected:
    /// A post of 2 units on a floor, seen from above with -Z up in the picture: 10 pixels per unit.
    ProcessResult plan(const Words& more) {
        return runEdgeshade(Words{"render", scene(), folder_ / "out.png", "--size", "160x160",
                                  "--ortho", "16", "--camera-matrix",
                                  "1,0,0,0,0,0,1,0,0,-1,0,0,0,0,-20,1", "--report",
                                  folder_ / "report.json"} +
                            more);
    }

    std::string scene() {
        GltfBuilder gltf;
        gltf.addShapeNode(box(glm::vec3(0.3f, 2.0f, 0.3f)), {{"translation", {0, 0, 0}}});
        gltf.addShapeNode(box(glm::vec3(8.0f, 0.1f, 8.0f)), {{"translation", {0, -0.1, 0}}});
        return folder_.write("post.glb", gltf.glb());
    }

    Json report() {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }

    Image mask(const Words& more) {
        const ProcessResult result = plan(Words{"--mask"} + more);
        EXPECT_EQ(result.status, 0) << result.err;
        return decodeImage(readFile(folder_ / "out.png"), "out.png");
    }

    TempFolder folder_;
};

/// Whether the mask is lit at this distance from the post in a compass direction (0 is -Z).
bool litAt(const Image& mask, double distance, double clockwise) {
    const double x = distance * std::sin(glm::radians(clockwise));
    const double z = -distance * std::cos(glm::radians(clockwise));
    const auto column = static_cast<std::size_t>(std::lround((x + 8.0) * 10.0 - 0.5));
    const auto row = static_cast<std::size_t>(std::lround((z + 8.0) * 10.0 - 0.5));
    return mask.rgba[4 * (row * static_cast<std::size_t>(mask.width) + column)] != 0;
}

} // namespace

TEST_F(SunByPlace, ShadowsFallAwayFromItAsFarAsItsAltitudeSays) {
    for (const Words& when : {noon, lateAutumn})
        for (const char* north : {"0", "90", "-135"}) {
            const Image picture = mask(when + Words{"--north", north});
            const Json sun = report()["settings"]["sun"];
            const double length = 2.0 / std::tan(glm::radians(sun["altitude"].get<double>()));
            const double away = sun["azimuth"].get<double>() + 180.0 + std::stod(north);
            ASSERT_GT(length, 1.0);
            EXPECT_FALSE(litAt(picture, length - 0.3, away)) << north;
            EXPECT_TRUE(litAt(picture, length + 0.8, away)) << north;
            EXPECT_TRUE(litAt(picture, length - 0.3, away + 180.0)) << north;
        }
}

TEST_F(SunByPlace, IsReported) {
    ASSERT_EQ(plan(noon + Words{"--north", "30"}).status, 0);
    const Json all = report();
    const Json sun = all["settings"]["sun"];
    EXPECT_EQ(sun["place"], (Json{48.14, 11.57}));
    EXPECT_EQ(sun["time"], "2026-06-21T14:30+02:00");
    EXPECT_EQ(sun["north"], 30.0);
    EXPECT_EQ(sun["up"], true);
    EXPECT_NEAR(sun["azimuth"].get<double>(), 217.465, 0.01);
    EXPECT_NEAR(sun["altitude"].get<double>(), 61.227, 0.01);
    EXPECT_LT(sun["airless_altitude"], sun["altitude"]);
    const auto direction = sun["direction"].get<std::vector<double>>();
    EXPECT_NEAR(direction[1], std::sin(glm::radians(sun["altitude"].get<double>())), 1e-12);
    ASSERT_EQ(all["lights"].size(), 1u);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(all["lights"][0]["position"][i], direction[i]);
    EXPECT_EQ(all["lights"][0]["position"][3], 0.0);
    ASSERT_EQ(plan({"--sun", "0,1,0"}).status, 0);
    EXPECT_FALSE(report()["settings"].contains("sun"));
}

TEST_F(SunByPlace, IsTheLightThatTheSameDirectionTyped) {
    ASSERT_EQ(plan(noon).status, 0);
    const Bytes byPlace = readFile(folder_ / "out.png");
    const Json direction = report()["settings"]["sun"]["direction"];
    ASSERT_EQ(
        plan({"--sun", direction[0].dump() + "," + direction[1].dump() + "," + direction[2].dump()})
            .status,
        0);
    EXPECT_EQ(readFile(folder_ / "out.png"), byPlace);
}

TEST_F(SunByPlace, StandsBeforeTypedLamps) {
    ASSERT_EQ(plan(Words{"--light", "1,5,2"} + noon).status, 0);
    const Json lights = report()["lights"];
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0]["position"][3], 0.0);
    EXPECT_EQ(lights[1]["position"], (Json{1.0, 5.0, 2.0, 1.0}));
}

TEST_F(SunByPlace, BelowTheHorizonLightsNothingAndSaysSo) {
    const ProcessResult result = plan(night + Words{"--mask"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("warning: At 2026-06-21T01:00+02:00 the sun at 48.14,11.57 is 18."),
              std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("below the horizon, so it lights nothing"), std::string::npos);
    const Json all = report();
    EXPECT_EQ(all["lit_pixels"], 0);
    EXPECT_EQ(all["visible_pixels"], 160 * 160);
    EXPECT_EQ(all["settings"]["sun"]["up"], false);
    ASSERT_EQ(all["warnings"].size(), 1u);

    // The picture has only ambient light: it is the same whatever the lamp that the sun replaces.
    ASSERT_EQ(plan(night).status, 0);
    const Bytes dark = readFile(folder_ / "out.png");
    ASSERT_EQ(plan(night + Words{"--shadows", "none"}).status, 0);
    EXPECT_EQ(readFile(folder_ / "out.png"), dark);
    ASSERT_EQ(plan(noon).status, 0);
    EXPECT_NE(readFile(folder_ / "out.png"), dark);
}

TEST_F(SunByPlace, LampsStayOnAtNight) {
    ASSERT_EQ(plan(night).status, 0);
    const Bytes dark = readFile(folder_ / "out.png");
    ASSERT_EQ(plan(night + Words{"--light", "1,5,2"}).status, 0);
    EXPECT_NE(readFile(folder_ / "out.png"), dark);
}

TEST_F(SunByPlace, WithoutItNothingIsMeasured) {
    for (const Words& verb :
         {Words{"compare", scene()}, {"bench", scene()}, {"tradeoff", scene()}}) {
        const ProcessResult result = runEdgeshade(verb + night);
        if (result.status == 3) continue; // built without the oracle
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find("--time-of-day: At 2026-06-21T01:00+02:00 the sun"),
                  std::string::npos)
            << result.err;
    }
}

TEST_F(SunByPlace, IsComparedAndBenched) {
    const ProcessResult compared =
        runEdgeshade(Words{"compare", scene(), "--size", "96x64", "--views", "2", "--report",
                           folder_ / "report.json"} +
                     noon);
    if (compared.status != 3) {
        ASSERT_EQ(compared.status, 0) << compared.err;
        EXPECT_EQ(report()["wrong_image_beyond_1px_not_tied"], 0);
        EXPECT_NEAR(report()["settings"]["sun"]["azimuth"].get<double>(), 217.465, 0.01);
        EXPECT_EQ(report()["lights"].size(), 1u);
    }
    const ProcessResult benched =
        runEdgeshade(Words{"bench", scene(), "--size", "64x48", "--frames", "2", "--warm-up", "0",
                           "--report", folder_ / "report.json"} +
                     noon);
    ASSERT_EQ(benched.status, 0) << benched.err;
    EXPECT_NEAR(report()["settings"]["sun"]["azimuth"].get<double>(), 217.465, 0.01);
}

} // namespace edgeshade::test
