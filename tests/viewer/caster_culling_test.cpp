// Casters that are left out of volumes where lights rest or move slowly (docs/method.md, C43), in
// the background.
#include "src/viewer/light_pace.hpp"
#include "src/viewer/light_rest.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 160, height = 120;

/// Boxes, most of them under a roof.
LoadedScene boxesUnderRoof() {
    test::SceneBuilder builder;
    builder.floor(6.0f).box({-3, 3, -3}, {3, 3.3f, 3});
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 low(-4.0f + 0.8f * static_cast<float>(i % 10), 0.1f,
                            -4.0f + 0.8f * static_cast<float>(i / 10));
        builder.box(low, low + glm::vec3(0.3f, 0.5f, 0.3f));
    }
    const Scene scene = builder.scene();
    return {{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
}

class ViewerCulling : public testing::Test {
  protected:
    ViewerCulling() { show(viewer); }

    static ViewerSettings culling() {
        ViewerSettings settings;
        settings.render.casterCulling = true;
        return settings;
    }

    static void show(Viewer& of) {
        of.resize(width, height, 1.0);
        of.show(boxesUnderRoof());
        of.change({{"show_lights", false}, {"left", {{"shadows", "volumes"}}}});
        of.change({{"lights", Json::array({sunAt(0.0)})}});
    }

    /// Turned by so many degrees.
    static Json sunAt(double degrees) {
        const double angle = glm::radians(20.0 + degrees);
        return {std::sin(angle), std::cos(angle), 0.2, 0};
    }

    bool leavesOut() const {
        return viewer.stats().lights.at(0).why.find("triangles are left out") != std::string::npos;
    }

    /// Draws until nothing more is wanted, a minute by the clock at most; `now` goes on.
    void settle() {
        for (int i = 0; i < 6000 && viewer.wantsFrame(); ++i) {
            now += 0.01;
            if (!viewer.frame(now)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }

    /// Turns the sun for a while; in how many of 200 pictures casters were left out.
    int turn(double degreesASecond) {
        int count = 0;
        for (int i = 0; i < 200; ++i) {
            now += 0.05;
            at += 0.05 * degreesASecond;
            viewer.change({{"lights", Json::array({sunAt(at)})}});
            viewer.frame(now);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            count += leavesOut();
        }
        return count;
    }

    /// Beside the scene now with all casters counted, which is drawn over it.
    std::size_t wrongPixels() {
        const Pixels here = context.readPixels();
        Viewer all{context.capabilities()};
        show(all);
        all.change({{"lights", Json::array({sunAt(at)})}});
        all.frame(now);
        const Pixels there = context.readPixels();
        std::size_t count = 0;
        for (std::size_t i = 0; i < here.size(); i += 4)
            count += !std::equal(&here[i], &here[i] + 4, &there[i]);
        return count;
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities(), culling()};
    double now = 1.0, at = 0.0;
};

TEST_F(ViewerCulling, CastersAreLeftOutOnceTheLightRests) {
    viewer.frame(now);
    EXPECT_FALSE(leavesOut());
    EXPECT_TRUE(viewer.wantsFrame());
    settle();
    EXPECT_TRUE(leavesOut());
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_LT(wrongPixels(), 10u);
    at = 30.0;
    viewer.change({{"lights", Json::array({sunAt(at)})}});
    viewer.frame(now += 0.01);
    EXPECT_FALSE(leavesOut()) << "those of another place";
    EXPECT_LT(wrongPixels(), 10u);
}

TEST_F(ViewerCulling, CastersAreLeftOutOfSlowSuns) {
    EXPECT_GT(turn(0.04), 50);
    EXPECT_TRUE(leavesOut());
    EXPECT_LT(wrongPixels(), 10u);
    const std::string moving = viewer.stats().lights.at(0).why;
    settle();
    EXPECT_TRUE(leavesOut());
    EXPECT_NE(viewer.stats().lights.at(0).why, moving) << "more go where it rests";
}

TEST_F(ViewerCulling, NoneAreLeftOutOfFastSuns) {
    EXPECT_EQ(turn(2.0), 0);
    settle();
    EXPECT_TRUE(leavesOut());
}

TEST_F(ViewerCulling, OthersReceiveWhereTheGroundIsSeen) {
    viewer.change({{"ground", "catcher"}});
    settle();
    EXPECT_TRUE(leavesOut());
    viewer.change({{"ground", "off"}});
    EXPECT_FALSE(leavesOut());
    settle();
    EXPECT_TRUE(leavesOut());
}

TEST_F(ViewerCulling, AnotherSceneStopsWhatIsBeingFound) {
    viewer.frame(now);
    viewer.frame(now += 2.0 * LightRest::enough);
    show(viewer);
    settle();
    EXPECT_TRUE(leavesOut());
}

TEST(LightPace, TellsHowFarSlowLightsGet) {
    LightPace pace;
    const auto sunAt = [](double degrees) {
        return Light{{std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0, 0}};
    };
    const Light lamp{{1, 2, 3, 1}};
    pace.see({sunAt(0.0), lamp}, 10.0);
    EXPECT_EQ(pace.wanderOf(0, 10.0), 0.0);
    const Light moved = lamp.at({1, 2, 3.002, 1});
    pace.see({sunAt(0.02), moved}, 10.5);
    EXPECT_NEAR(pace.wanderOf(0, 10.0), LightPace::ahead * glm::radians(0.04), 1e-9);
    EXPECT_NEAR(pace.wanderOf(1, 10.0), LightPace::ahead * 0.004, 1e-9);
    EXPECT_EQ(pace.wanderOf(1, 1.0), 0.0) << "fast in a small scene";
    EXPECT_EQ(pace.wanderOf(2, 10.0), 0.0);
    pace.see({sunAt(0.02), moved}, 11.0);
    EXPECT_EQ(pace.wanderOf(0, 10.0), 0.0) << "it rests";
    pace.see({sunAt(5.0), sunAt(0.0)}, 11.5);
    EXPECT_EQ(pace.wanderOf(0, 10.0), 0.0);
    EXPECT_EQ(pace.wanderOf(1, 10.0), 0.0) << "another kind of light";
    pace.see({sunAt(5.0)}, 12.0);
    EXPECT_EQ(pace.wanderOf(0, 10.0), 0.0);
}

} // namespace
} // namespace edgeshade::viewer
