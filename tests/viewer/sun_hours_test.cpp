// Hours of sunlight in the viewer, against the counts of `edgeshade sunhours`.
#include "src/hours/schedule.hpp"
#include "src/plot/color_scale.hpp"
#include "src/render/accumulation/direction_counts.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr int width = 80, height = 60;

class ViewerHours : public testing::Test {
  protected:
    ViewerHours() {
        viewer.resize(width, height, 1.0);
        viewer.show(test::loadedOf(test::yard().scene()));
        viewer.change(Json::parse(R"({"show_lights": false, "ground": "off",
            "camera": {"from": [5, 7, 9], "to": [0, 0, 0], "fov": 50}, "sun":
            {"place": [48.14, 11.57], "time": "2026-03-21T10:00+01:00", "north": 20}})"));
    }

    void ask(int step = 30) { viewer.change({{"sun_hours", true}, {"sun_hours_step", step}}); }
    bool frame() { return viewer.frame(now += 0.016); }

    /// Draws until the viewer wants no more frames; returns the number of pictures.
    int settle() {
        int pictures = 0;
        for (int i = 0; i < 20000 && viewer.wantsFrame(); ++i)
            pictures += frame();
        return pictures;
    }

    /// The counts of `edgeshade sunhours` for the state's view and day.
    LitCounts counted(const char* date, int step) {
        hours::Schedule schedule;
        schedule.place = viewer.state().sun->place;
        schedule.offset = viewer.state().sun->time.offset;
        schedule.from = schedule.to = sun::dateFromText(date);
        schedule.step = std::chrono::minutes(step);
        schedule.north = viewer.state().sun->north;
        std::vector<glm::dvec3> directions;
        for (const hours::Position& position : hours::positionsOf(schedule))
            directions.push_back(position.direction);
        const LoadedScene loaded = test::loadedOf(test::yard().scene());
        FrameRequest request;
        request.frustum = frustumOf(viewer.state().camera, static_cast<double>(width) / height);
        request.width = width;
        request.height = height;
        RenderSettings settings;
        settings.shading = Shading::base;
        settings.layout = bestLayout(context.capabilities());
        Renderer renderer(settings, context.capabilities());
        GpuScene scene = uploadScene(loaded, settings.records(), context.capabilities());
        return countDirections(loaded, request, directions, renderer, scene, context.capabilities(),
                               [](double) {});
    }

    void expectCounts(const LitCounts& expected) {
        std::size_t different = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto i = static_cast<std::size_t>(y * width + x);
                const auto lit = viewer.sunHoursAt(x + 0.5, y + 0.5);
                different += lit.has_value() != (expected.surface[i] > 0) ||
                             lit.value_or(0) != (lit ? expected.lit[i] : 0u);
            }
        EXPECT_EQ(different, 0u);
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities()};
    double now = 1.0;
};

TEST_F(ViewerHours, AreTheCountsOfTheProgram) {
    ask();
    settle();
    const LitCounts expected = counted("2026-03-21", 30);
    EXPECT_EQ(viewer.sunHours()->of, expected.lights);
    EXPECT_EQ(viewer.sunHours()->counted, expected.lights);
    EXPECT_EQ(viewer.sunHours()->step, 30);
    EXPECT_GT(std::set(expected.lit.begin(), expected.lit.end()).size(), 10u) << "no scene of many";
    expectCounts(expected);
}

TEST_F(ViewerHours, AreShownInTheColoursOfTheProgram) {
    ask();
    viewer.change(Json::parse(R"({"background": [1, 0, 1]})"));
    settle();
    const std::vector<std::uint8_t> shown = context.readPixels();
    const LitCounts expected = counted("2026-03-21", 30); // this may overwrite the viewer's picture
    for (std::size_t i = 0; i < expected.lit.size(); ++i) {
        const double share = static_cast<double>(expected.lit[i]) / expected.lights;
        const plot::Color color = expected.surface[i] == 0 ? 0xFF00FF : plot::evenColor(share);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(shown[4 * i + c], color >> (16 - 8 * c) & 0xFF, 2) << i;
        ASSERT_EQ(shown[4 * i + 3], 255);
    }
}

TEST_F(ViewerHours, ComeOnceAllPositionsAreCountedAndNotBefore) {
    viewer.frame(now);
    settle();
    const std::vector<std::uint8_t> usual = context.readPixels();
    ask(10);
    ASSERT_TRUE(frame());
    EXPECT_EQ(context.readPixels(), usual);
    std::size_t last = 0;
    while (viewer.wantsFrame()) {
        EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2));
        const bool drew = frame();
        const SunHours hours = *viewer.sunHours();
        EXPECT_GT(hours.counted, last);
        EXPECT_LE(hours.counted, last + 8);
        EXPECT_EQ(drew, hours.counted == hours.of);
        last = hours.counted;
    }
    EXPECT_EQ(last, 73u);
    EXPECT_TRUE(viewer.sunHoursAt(width / 2, height / 2));
    EXPECT_NE(context.readPixels(), usual);
    viewer.change({{"sun_hours", false}});
    settle();
    EXPECT_EQ(context.readPixels(), usual);
    EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2));
}

TEST_F(ViewerHours, AreNotCountedWhereNobodyAsks) {
    settle();
    EXPECT_FALSE(viewer.sunHours());
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2));
}

TEST_F(ViewerHours, WhatMovesStartsAnew) {
    ask();
    settle();
    for (const char* change :
         {R"({"camera": {"from": [5, 7, 9.1]}})", R"({"sun": {"time": "2026-06-21T10:00+02:00"}})",
          R"({"sun": {"place": [50, 11]}})", R"({"sun": {"north": 30}})",
          R"({"sun_hours_step": 60})", R"({"cull": "auto"})"}) {
        viewer.change(Json::parse(change));
        ASSERT_TRUE(frame());
        EXPECT_EQ(viewer.sunHours()->counted, 0u) << change;
        EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2)) << change;
        settle();
        EXPECT_EQ(viewer.sunHours()->counted, viewer.sunHours()->of) << change;
    }
    viewer.change({{"cull", "off"}});
    settle();
    expectCounts(counted("2026-06-21", 60));
}

TEST_F(ViewerHours, AnotherTimeOfTheDayKeepsThem) {
    ask();
    settle();
    const std::vector<std::uint8_t> before = context.readPixels();
    for (const char* change : {R"({"sun": {"time": "2026-03-21T23:50+01:00"}})",
                               R"({"sun": {"time": "2026-03-21T00:00+01:00"}})",
                               R"({"ambient": 0.9})", R"({"left": {"shadows": "none"}})"}) {
        viewer.change(Json::parse(change));
        ASSERT_TRUE(frame());
        EXPECT_FALSE(viewer.wantsFrame()) << change;
        EXPECT_EQ(context.readPixels(), before) << change;
    }
    // The day before, by one minute on the clock.
    viewer.change(Json::parse(R"({"sun": {"time": "2026-03-20T23:59+01:00"}})"));
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.sunHours()->counted, 0u);
}

TEST_F(ViewerHours, GiveWayWhileADayPlays) {
    ask();
    settle();
    const std::vector<std::uint8_t> before = context.readPixels();
    viewer.change({{"day_playing", true}});
    ASSERT_TRUE(frame());
    EXPECT_NE(context.readPixels(), before);
    EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2));
    viewer.change({{"day_playing", false}});
    ASSERT_TRUE(frame());
    EXPECT_EQ(context.readPixels(), before);
}

TEST_F(ViewerHours, TakeTheWholePictureOfASplit) {
    ask();
    settle();
    const std::vector<std::uint8_t> before = context.readPixels();
    viewer.change(Json::parse(R"({"split": true})"));
    settle();
    EXPECT_EQ(context.readPixels(), before);
}

TEST_F(ViewerHours, LeaveSoftShadowsForLater) {
    Json light = toJson(viewer.state())["lights"][0];
    light.erase(3);
    viewer.change({{"lights", {{{"direction", light}, {"angle", 2}}}}, {"light_samples", 16}});
    ASSERT_TRUE(viewer.state().sun);
    ask();
    settle();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
    EXPECT_TRUE(viewer.sunHoursAt(width / 2, height / 2));
    viewer.change({{"sun_hours", false}});
    settle();
    EXPECT_EQ(viewer.lightPoints().shown, 16u);
}

TEST_F(ViewerHours, APolarNightHasNone) {
    settle();
    ask();
    viewer.change(
        Json::parse(R"({"sun": {"place": [78.2, 15.6], "time": "2026-12-21T12:00+01:00"}})"));
    settle();
    EXPECT_EQ(viewer.sunHours()->of, 0u);
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_FALSE(viewer.sunHoursAt(width / 2, height / 2));
}

TEST_F(ViewerHours, ALostContextCountsAnew) {
    ask();
    settle();
    const std::vector<std::uint8_t> before = context.readPixels();
    viewer.forgetGpu();
    EXPECT_FALSE(viewer.sunHours());
    EXPECT_FALSE(viewer.sunHoursAt(1, 1));
    viewer.restoreGpu(context.capabilities());
    settle();
    EXPECT_EQ(context.readPixels(), before);
    EXPECT_FALSE(viewer.sunHoursAt(-1, 0));
    EXPECT_FALSE(viewer.sunHoursAt(0, height));
}

TEST_F(ViewerHours, AreStated) {
    ask(15);
    const Json state = toJson(viewer.state());
    EXPECT_EQ(state["sun_hours"], true);
    EXPECT_EQ(state["sun_hours_step"], 15);
    viewer.change({{"sun_hours", false}, {"sun_hours_step", 60}});
    viewer.change(state);
    EXPECT_EQ(toJson(viewer.state()), state);
    for (const auto& [changes, words] :
         {std::pair(R"({"sun_hours": 1})", "sun_hours is 1, but must be true or false"),
          {R"({"sun_hours_step": 7})", "sun_hours_step is 7, but must be minutes that divide"},
          {R"({"sun_hours_step": 0})", "a number from 1.0 to 1440.0"},
          {R"({"sun_hours_step": 2.5})", "a whole number"}})
        try {
            viewer.change(Json::parse(changes));
            ADD_FAILURE() << changes;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::usage);
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    EXPECT_EQ(toJson(viewer.state()), state);
    // Hours need a sun by place and time.
    viewer.change(Json::parse(R"({"lights": [[0, 1, 0, 0]]})"));
    EXPECT_FALSE(viewer.state().sunHours);
    viewer.change({{"sun_hours", true}});
    EXPECT_FALSE(viewer.state().sunHours);
    viewer.run(Command::toggleHours);
    EXPECT_FALSE(viewer.state().sunHours);
    viewer.change({{"sun", state["sun"]}});
    viewer.run(Command::toggleHours);
    EXPECT_TRUE(viewer.state().sunHours);
    viewer.run(Command::reset);
    EXPECT_FALSE(viewer.state().sunHours);
}

} // namespace
} // namespace edgeshade::viewer
