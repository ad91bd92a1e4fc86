// Lights of a file (KHR_lights_punctual): where its nodes place them, and what they are in a
// picture.
#include "src/shadow/geometry/scene_lights.hpp"

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
    expectNear(glm::dvec3(sun.position), {1, 0, 0}); // towards it
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
    const double quarter = 1.57079637; // a float's right angle, a little more than one
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
    EXPECT_NE(warnedOf({{"scale", {1, 1, 0}}}, "spot").find("scaled to nothing"),
              std::string::npos);
    EXPECT_NE(warnedOf({{"scale", {0, 0, 0}}}, "directional").find("scaled to nothing"),
              std::string::npos);
    EXPECT_NE(warnedOf({{"translation", {0, -1e300, 0}}}, "point").find("farther than 1e12"),
              std::string::npos);
}

} // namespace edgeshade::test
