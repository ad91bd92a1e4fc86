// Lights of a file (KHR_lights_punctual): their placement by nodes, and their effect in a picture.
#include "src/shadow/lights/scene_lights.hpp"

#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const std::string name = "KHR_lights_punctual";
const Json turnedAroundY = {0.0, std::sqrt(0.5), 0.0,
                            std::sqrt(0.5)}; // 90 degrees: shines along -x

/// A box and a light under each of the nodes.
Scene sceneWith(const Json& light, const std::vector<Json>& nodes) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.useExtension(name);
    gltf.json["extensions"][name]["lights"] = Json::array({light});
    for (Json node : nodes) {
        node["extensions"][name]["light"] = 0;
        gltf.addNode(node);
    }
    return sceneOf(gltf);
}

Light lightUnder(const Json& node, const Json& light) {
    const Scene scene = sceneWith(light, {node});
    EXPECT_TRUE(scene.warnings.sentences().empty());
    EXPECT_EQ(lightsOf(scene).size(), 1u);
    return lightsOf(scene).at(0);
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::distance(a, b), 1e-7) << a.x << ", " << a.y << ", " << a.z;
}

} // namespace

TEST(SceneLights, ADirectionalLightShinesAlongItsNodesMinusZ) {
    const Light sun = lightUnder(
        {{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}},
        {{"type", "directional"}, {"color", {1.0, 0.5, 0.0}}, {"intensity", 3.0}, {"range", 2.0}});
    EXPECT_EQ(sun.position.w, 0.0);
    expectNear(glm::dvec3(sun.position), {1, 0, 0}); // towards the sun
    expectNear(sun.color, {3, 1.5, 0});
    EXPECT_TRUE(sun.photometric);
    EXPECT_FALSE(sun.hasRange());
    EXPECT_FALSE(sun.isSpot());
}

TEST(SceneLights, APointLightIsInCandela) {
    const Light lamp = lightUnder({{"translation", {5, 1, 0}}, {"scale", {2, 2, 2}}},
                                  {{"type", "point"}, {"intensity", 40}, {"range", 7}});
    EXPECT_EQ(lamp.position, glm::dvec4(5, 1, 0, 1));
    expectNear(lamp.color, {40, 40, 40});
    EXPECT_TRUE(lamp.photometric);
    EXPECT_EQ(lamp.range, 7.0) << "scale leaves it as it is";
    EXPECT_FALSE(lamp.isSpot());
    const Light plain = lightUnder(Json::object(), {{"type", "point"}});
    EXPECT_EQ(plain.color, glm::vec3(1.0f));
    EXPECT_FALSE(plain.hasRange());
}

TEST(SceneLights, APointLightNeedsNoTurn) {
    const Light lamp =
        lightUnder({{"translation", {5, 1, 0}}, {"scale", {0, 0, 0}}}, {{"type", "point"}});
    EXPECT_EQ(lamp.position, glm::dvec4(5, 1, 0, 1));
}

TEST(SceneLights, ASpotHasACone) {
    for (const Json& scale : {Json{1, 1, 1}, Json{-3, 3, 3}, Json{1, 5, 0.2}}) {
        const Light spot = lightUnder(
            {{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}, {"scale", scale}},
            {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}});
        ASSERT_TRUE(spot.isSpot());
        expectNear(spot.cone->axis, {-1, 0, 0});
        EXPECT_NEAR(glm::length(spot.cone->axis), 1.0, 1e-15);
        EXPECT_EQ(spot.cone->inner, 0.1);
        EXPECT_EQ(spot.cone->outer, 0.2);
    }
    const Light plain = lightUnder(Json::object(), {{"type", "spot"}, {"spot", Json::object()}});
    EXPECT_EQ(plain.cone->inner, 0.0);
    EXPECT_DOUBLE_EQ(plain.cone->outer, std::numbers::pi / 4.0);
}

TEST(SceneLights, AnglesMayBeRoundedToFloats) {
    const double quarter = 1.57079637; // a right angle in floats, slightly larger than the exact
                                       // one
    const Light wide = lightUnder(
        Json::object(),
        {{"type", "spot"}, {"spot", {{"innerConeAngle", quarter}, {"outerConeAngle", quarter}}}});
    EXPECT_DOUBLE_EQ(wide.cone->outer, std::numbers::pi / 2.0);
    EXPECT_LE(wide.cone->inner, wide.cone->outer);
}

TEST(SceneLights, AreThoseOfTheScenesVisibleNodes) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json["extensions"][name]["lights"] = {{{"type", "point"}, {"name", "lamp"}},
                                               {{"type", "directional"}}};
    const auto with = [](int light) { return Json{{name, {{"light", light}}}}; };
    const int child = gltf.addNode({{"extensions", with(1)}, {"name", "sky"}}, false);
    gltf.addNode({{"extensions", with(0)}, {"name", "nowhere"}}, false);
    gltf.addNode({{"children", {child}}});
    Json hidden = with(0);
    hidden["KHR_node_visibility"] = {{"visible", false}};
    gltf.addNode({{"extensions", hidden}});
    gltf.addNode({{"extensions", with(0)}, {"name", "desk"}});
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].nodeName, "sky");
    EXPECT_EQ(scene.lights[1].name, "lamp");
    EXPECT_EQ(scene.lights[1].nodeName, "desk");
    EXPECT_TRUE(scene.warnings.sentences().empty());
}

TEST(SceneLights, APictureHasTheFirstThousand) {
    const Scene scene = sceneWith({{"type", "point"}}, std::vector<Json>(1001, Json::object()));
    EXPECT_EQ(scene.lights.size(), 1001u);
    EXPECT_EQ(lightsOf(scene).size(), 1000u);
}

TEST(SceneLights, WhatScalesBy0LeavesTheirDirections) {
    const Json turned = {-0.42261826174069944, 0.0, 0.0, 0.9063077870366499}; // 50 degrees down
    const glm::dvec3 down(0, -0.76604444311897801, -0.64278760968653936);
    const auto axisOf = [](const Json& node, const Json& parent = Json::object()) {
        GltfBuilder gltf;
        gltf.addShapeNode(box(glm::vec3(1.0f)));
        gltf.useExtension(name);
        gltf.json["extensions"][name]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}}};
        Json lit = node;
        lit["extensions"][name]["light"] = 0;
        Json above = parent;
        above["children"] = {gltf.addNode(lit, false)};
        gltf.addNode(above);
        const Scene scene = sceneOf(gltf);
        EXPECT_TRUE(scene.warnings.sentences().empty());
        return scene.lights.empty() ? glm::dvec3(0.0) : scene.lights[0].direction;
    };
    for (const Json& scale : {Json{1, 0, 1}, Json{0, 1, 1}, Json{1, 1, 0}, Json{0, 0, 0},
                              Json{2, 0, 0}, Json{0, 0, -3}}) {
        const double sign = scale[2] == -3 ? -1.0 : 1.0; // as for a scale without zeros
        expectNear(axisOf({{"rotation", turned}, {"scale", scale}}), sign * down);
    }
    // A flat parent leaves part of the direction; if nothing is left, the rotations decide.
    expectNear(axisOf({{"rotation", turned}}, {{"scale", {0, 0, 0}}}), down);
    expectNear(axisOf({{"rotation", turned}}, {{"scale", {1, 0, 1}}}), {0, 0, -1});
    expectNear(
        axisOf({{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}}, {{"scale", {1, 0, 1}}}),
        {0, -1, 0});
    // A matrix with a zero column gives as much.
    expectNear(axisOf({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}}}), {0, 0, -1});
}

TEST(SceneLights, ARangeOf0IsNone) {
    for (const char* type : {"point", "spot", "directional"}) {
        Json light = {{"type", type}, {"range", 0}};
        if (light["type"] == "spot") light["spot"] = Json::object();
        const Scene scene = sceneWith(light, {Json::object()});
        ASSERT_EQ(lightsOf(scene).size(), 1u) << type;
        EXPECT_FALSE(lightsOf(scene)[0].hasRange());
        ASSERT_EQ(scene.warnings.sentences().size(), 1u);
        EXPECT_EQ(warningsWith(scene, "lights[0].range is 0"), 1u) << type;
    }
    const Scene sun = sceneWith({{"type", "directional"}, {"range", -1}}, {Json::object()});
    EXPECT_EQ(sun.lights.size(), 1u) << "it has no range that could be wrong";
}

TEST(SceneLights, OnesThatCannotBePlacedAreLeftOut) {
    const auto warnedOf = [](const Json& node, const std::string& type) {
        Json light = {{"type", type}};
        if (type == "spot") light["spot"] = Json::object();
        const Scene scene = sceneWith(light, {node});
        EXPECT_TRUE(scene.lights.empty());
        EXPECT_EQ(scene.warnings.sentences().size(), 1u);
        const std::string said = scene.warnings.sentences().at(0);
        EXPECT_NE(said.find("nodes[1].extensions.KHR_lights_punctual.light"), std::string::npos);
        EXPECT_NE(said.find("; the light is left out."), std::string::npos) << said;
        return said;
    };
    EXPECT_NE(warnedOf({{"matrix", {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}}}, "spot")
                  .find("transform is degenerate"),
              std::string::npos)
        << "nothing tells how it is turned";
    EXPECT_NE(warnedOf({{"translation", {0, -1e300, 0}}}, "point").find("farther than 1e12"),
              std::string::npos);
}

} // namespace edgeshade::test
