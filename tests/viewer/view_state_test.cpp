// The state's JSON: reading gives back what was written, and errors are named.

#include "preprocess/base/error.hpp"
#include "src/viewer/view_state.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

ViewState someState() {
    ViewState state;
    state.camera = {{1.25, -2, 1e6 + 0.001}, {0.1, 0.2, 0.3}, 60.5};
    state.lights = {{{1, 2, 3, 1}, 4.5}, {{0.1, 0.7, -0.3, 0}}};
    state.chosenLight = 1;
    state.lightSamples = 100;
    state.sun = {{-33.87, 151.21}, sun::localTimeFromText("2024-02-29T12:00:30+11:00"), -30.0};
    state.dayPlays = true;
    state.sunHours = true;
    state.sunHoursStep = 15;
    state.smooth = 16;
    state.shading = Shading::base;
    state.ambient = 0.25f;
    state.exposure = -1.5f;
    state.background = {0.1f, 0.2f, 0.3f};
    state.ground = Ground{GroundMaterial::surface, glm::vec3(1.0f, 0.0f, 1.0f)};
    state.section = Section{{{1, 0, 0, -0.25}, {0.1, -2, 3, 1e7}}, SectionShadows::whole, {}};
    state.castCutouts = true;
    state.culls = !cullsByDefault;
    state.left = {ShadowMethod::map, MultiplicityMethod::threeEdge, 1, {.size = 512}};
    state.right = {ShadowMethod::none, MultiplicityMethod::singleEdge, 4, {.size = 64}};
    state.split = true;
    state.splitAt = 0.3;
    state.debug = DebugView::volumes;
    state.showLights = false;
    state.animation = 3;
    state.playing = true;
    state.speed = 2.5;
    state.time = 12.75;
    return state;
}

/// Expects that `changes` are refused with a message that has `name` and `value`.
void expectRefused(const std::string& changes, const std::string& name, const std::string& value) {
    SCOPED_TRACE(changes);
    try {
        changed(someState(), Json::parse(changes));
        ADD_FAILURE() << "was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::usage);
        const std::string sentence = error.what();
        EXPECT_NE(sentence.find(name), std::string::npos) << sentence;
        EXPECT_NE(sentence.find(value), std::string::npos) << sentence;
    }
}

TEST(LightState, NamesSayWhatAnArrayCanNot) {
    const auto read = [](const std::string& light) {
        return changed(someState(), {{"lights", {Json::parse(light)}}}).lights.at(0);
    };
    const Light lamp = read(R"({"position": [1, 2, 3], "color": [1, 0.5, 0], "intensity": 8,
        "range": 4, "cone": {"axis": [0, -2, 0], "inner": 10, "outer": 30}})");
    EXPECT_EQ(lamp.position, glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(lamp.color, glm::vec3(8, 4, 0));
    EXPECT_TRUE(lamp.photometric);
    EXPECT_EQ(lamp.range, 4.0);
    ASSERT_TRUE(lamp.isSpot());
    EXPECT_EQ(lamp.cone->axis, glm::dvec3(0, -1, 0));
    EXPECT_NEAR(lamp.cone->inner, glm::radians(10.0), 1e-15);
    EXPECT_NEAR(lamp.cone->outer, glm::radians(30.0), 1e-15);
    const Light dim = read(R"({"position": [1, 2, 3], "color": [0.5, 0.25, 0]})");
    EXPECT_FALSE(dim.photometric);
    const Light sun = read(R"({"direction": [0, 1, 0], "intensity": 3})");
    EXPECT_EQ(sun.position.w, 0.0);
    EXPECT_EQ(sun.color, glm::vec3(3));
    EXPECT_TRUE(sun.photometric);
    for (const Light& light : {lamp, dim, sun}) {
        ViewState state = someState();
        state.lights = {light};
        const Json written = toJson(state)["lights"][0];
        ASSERT_TRUE(written.is_object());
        const Light again = read(written.dump());
        EXPECT_EQ(again.position, light.position);
        EXPECT_EQ(again.color, light.color);
        EXPECT_EQ(again.photometric, light.photometric);
        EXPECT_EQ(again.range, light.range);
        EXPECT_EQ(again.isSpot(), light.isSpot());
    }
}

TEST(ViewState, EveryKeySurvivesARoundTrip) {
    const Json json = toJson(someState());
    EXPECT_EQ(json.size(), 27u);
    EXPECT_EQ(toJson(changed(ViewState(), Json::parse(json.dump()))), json);
    EXPECT_NE(toJson(ViewState()), json);
}

TEST(ViewState, AKeyAloneChangesNothingElse) {
    Json expected = toJson(someState());
    expected["camera"]["fov"] = 30.0;
    expected["right"]["shadows"] = "volumes";
    EXPECT_EQ(
        toJson(changed(someState(),
                       Json::parse(R"({"camera": {"fov": 30}, "right": {"shadows": "volumes"}})"))),
        expected);
    EXPECT_EQ(toJson(changed(someState(), Json::object())), toJson(someState()));
}

TEST(ViewState, FewerLightsLeaveOneChosen) {
    EXPECT_EQ(changed(someState(), Json::parse(R"({"lights": [[0, 1, 0, 0]]})")).chosenLight, 0u);
}

TEST(ViewState, AnUnknownKeyIsRefused) {
    expectRefused(R"({"colour": 7})", "'colour'", "7");
    expectRefused(R"({"camera": {"roll": 8}})", "'camera.roll'", "8");
    expectRefused(R"({"left": {"taps": 3}})", "'left.taps'", "3");
}

TEST(ViewState, AValueOutOfRangeIsRefused) {
    expectRefused(R"({"ambient": 1.5})", "ambient", "1.5");
    expectRefused(R"({"camera": {"fov": 180}})", "camera.fov", "180");
    expectRefused(R"({"camera": {"fov": 0}})", "camera.fov", "0");
    expectRefused(R"({"camera": {"from": [1, 2, 1e300]}})", "camera.from[2]", "1e+300");
    expectRefused(R"({"camera": {"from": [1, 2, 3], "to": [1, 2, 3]}})", "camera", "[1,2,3]");
    expectRefused(R"({"lights": []})", "lights", "[]");
    expectRefused(R"({"lights": [[1, 2, 3, 0.5]]})", "lights[0]", "0.5");
    expectRefused(R"({"lights": [[0, 0, 0, 0]]})", "lights[0]", "[0,0,0,0]");
    expectRefused(R"({"lights": [[0, 1, 0, 1, 0]]})", "lights[0]", "[0,1,0,1,0]");
    expectRefused(R"({"lights": [[0, 1, 0, 1, -2]]})", "lights[0][4]", "-2");
    expectRefused(R"({"lights": [[0, 1, 0, 0, 3]]})", "lights[0]", "[0,1,0,0,3]");
    expectRefused(R"({"left": {"mask_scale": 3}})", "left.mask_scale", "3");
    expectRefused(R"({"left": {"mask_scale": 8}})", "left.mask_scale", "8");
    expectRefused(R"({"chosen_light": 2})", "chosen_light", "2");
    expectRefused(R"({"chosen_light": 0.5})", "chosen_light", "0.5");
    expectRefused(R"({"left": {"map_size": 15}})", "left.map_size", "15");
    expectRefused(R"({"right": {"shadows": "soft"}})", "right.shadows", "soft");
    expectRefused(R"({"left": {"map_kind": "trapezoid"}})", "left.map_kind", "trapezoid");
    expectRefused(R"({"left": {"warp": "none"}})", "left.warp", "none");
    expectRefused(R"({"left": {"cascades": 5}})", "left.cascades", "5");
    expectRefused(R"({"left": {"filter": "pcss"}})", "left.filter", "pcss");
    expectRefused(R"({"right": {"pcf": 4}})", "right.pcf", "4");
    expectRefused(R"({"split_at": -0.1})", "split_at", "-0.1");
    expectRefused(R"({"speed": 11})", "speed", "11");
    expectRefused(R"({"time": -1})", "time", "-1");
}

TEST(ViewState, AnotherKindOfValueIsRefused) {
    expectRefused("[]", "state", "[]");
    expectRefused(R"({"split": 1})", "split", "1");
    expectRefused(R"({"ambient": "much"})", "ambient", "much");
    expectRefused(R"({"camera": [1]})", "camera", "[1]");
    expectRefused(R"({"lights": [[1, 2, 3]]})", "lights[0]", "[1,2,3]");
    expectRefused(R"({"lights": [{}]})", "lights[0]", "{}");
    expectRefused(R"({"lights": [{"place": [1, 2, 3]}]})", "lights[0].place", "[1,2,3]");
    expectRefused(R"({"lights": [{"direction": [0, 0, 0]}]})", "lights[0].direction", "[0,0,0]");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "intensity": -1}]})",
                  "lights[0].intensity", "-1");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "range": 0}]})", "lights[0].range", "0");
    expectRefused(R"({"lights": [{"direction": [0, 1, 0], "range": 3}]})", "lights[0]", "range");
    expectRefused(R"({"lights": [{"direction": [0, 1, 0], "cone": {}}]})", "lights[0]", "cone");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "cone": {"axis": [0, 0, 0]}}]})",
                  "lights[0].cone.axis", "[0,0,0]");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "cone": {"outer": 91}}]})",
                  "lights[0].cone.outer", "91");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "cone": {"inner": 60}}]})",
                  "lights[0].cone", "60");
    expectRefused(R"({"lights": [{"position": [0, 0, 0], "direction": [0, 1, 0]}]})", "lights[0]",
                  "direction");
    expectRefused(R"({"time": null})", "time", "null");
}

TEST(ViewState, ASectionHasDefaultsAndAllMeanings) {
    const auto read = [](const std::string& section) {
        return toJson(changed(ViewState(), Json{{"section", Json::parse(section)}}))["section"];
    };
    EXPECT_EQ(read("null"), Json(nullptr));
    EXPECT_EQ(toJson(ViewState())["section"], Json(nullptr));
    const Json made = read(R"({"planes": [[0, 1, 0, -2]]})");
    EXPECT_EQ(made["planes"], Json::parse("[[0.0, 1.0, 0.0, -2.0]]"));
    EXPECT_EQ(made["shadows"], "cut");
    EXPECT_EQ(made["fill"], "#cc5540");
    const std::string all =
        R"({"planes":[[1.0,0.5,-3.0,1e+30]],"shadows":"whole","fill":"#0102ff"})";
    EXPECT_EQ(read(all), Json::parse(all));
    EXPECT_EQ(read(R"({"planes": [[1, 0, 0, 0]], "fill": "none"})")["fill"], "none");
    EXPECT_FALSE(changed(someState(), Json{{"section", nullptr}}).section);
}

TEST(ViewState, SectionsThatAreNoneAreRefused) {
    expectRefused(R"({"section": 1})", "section", "1");
    expectRefused(R"({"section": {}})", "section", "{}");
    expectRefused(R"({"section": {"shadows": "cut"}})", "section", "planes");
    expectRefused(R"({"section": {"planes": []}})", "section.planes", "[]");
    expectRefused(R"({"section": {"planes": [[0, 0, 0, 1]]}})", "section.planes[0]", "[0,0,0,1]");
    expectRefused(R"({"section": {"planes": [[0, 0, 1]]}})", "section.planes[0]", "[0,0,1]");
    expectRefused(R"({"section": {"planes": [[0, 0, 1, "x"]]}})", "section.planes[0][3]", "x");
    expectRefused(R"({"section": {"planes": [[1,0,0,0]], "shadows": "soft"}})", "section.shadows",
                  "soft");
    expectRefused(R"({"section": {"planes": [[1,0,0,0]], "fill": "red"}})", "section.fill", "red");
    expectRefused(R"({"section": {"planes": [[1,0,0,0]], "colour": "red"}})", "section.colour",
                  "red");
    Json planes = Json::array();
    for (int i = 0; i < 12; ++i)
        planes.push_back({1, 0, 0, i});
    EXPECT_EQ(changed(ViewState(), {{"section", {{"planes", planes}}}}).section->planes.size(),
              12u);
    planes.push_back({1, 0, 0, 12});
    EXPECT_THROW(changed(ViewState(), {{"section", {{"planes", planes}}}}), Error);
}

TEST(ViewState, WhatIsNotFiniteIsRefused) {
    for (const double value : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
        try {
            changed(someState(), Json{{"time", value}});
            ADD_FAILURE() << "was taken";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("time is not finite"), std::string::npos)
                << error.what();
        }
    }
}

} // namespace
} // namespace edgeshade::viewer
