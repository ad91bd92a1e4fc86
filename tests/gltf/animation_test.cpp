#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/gltf_builder.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const glm::dvec3 alongZ(0, 0, 1);
const float root = std::sqrt(0.5f); // the sine and cosine of 45 degrees

/// A moving scene, built channel by channel, and the result of reading it.
class MovingScene {
  public:
    GltfBuilder gltf;

    int addBox(Json node = Json::object(), bool isRoot = true) {
        node["mesh"] = gltf.addShape(box(glm::vec3(1.0f)));
        return gltf.addNode(std::move(node), isRoot);
    }

    /// A channel of the first animation, or of a later one.
    template <class T>
    void move(int node, const std::string& path, const std::vector<float>& times,
              const std::vector<T>& values, const std::string& interpolation = "",
              std::size_t animation = 0) {
        while (gltf.json["animations"].size() <= animation)
            gltf.json["animations"].push_back(Json::object());
        const bool isFloat = std::is_same_v<T, float>;
        Json sampler = {
            {"input", gltf.addArray(times, 1)},
            {"output", gltf.addArray(values, path == "rotation" ? 4 : 3,
                                     isFloat ? Json::object() : Json({{"normalized", true}}))}};
        if (!interpolation.empty()) sampler["interpolation"] = interpolation;
        Json& target = gltf.json["animations"][animation];
        target["samplers"].push_back(std::move(sampler));
        target["channels"].push_back({{"sampler", target["samplers"].size() - 1},
                                      {"target", {{"node", node}, {"path", path}}}});
    }

    std::optional<Animation> animation(std::optional<std::size_t> index = {}) {
        return readAnimation(parseGltf(gltf.glb(), "test.glb"), warnings, index);
    }
    Scene scene() const { return flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0); }

    /// worldFromBatch of the batch that `node` moves.
    std::optional<glm::dmat4> pose(int node, double seconds) {
        const Scene flat = scene();
        const auto all = poseAt(animation().value(), flat, seconds).worldFromBatch;
        EXPECT_EQ(all.size(), flat.batches.size());
        for (std::size_t b = 0; b < flat.batches.size(); ++b)
            if (flat.batches[b].node == node) return all[b];
        ADD_FAILURE() << "node " << node << " moves no batch";
        return std::nullopt;
    }

    Warnings warnings;
};

void expectMatrix(const std::optional<glm::dmat4>& actual, const glm::dmat4& expected,
                  double tolerance = 1e-6) {
    ASSERT_TRUE(actual);
    for (glm::length_t c = 0; c < 4; ++c)
        for (glm::length_t r = 0; r < 4; ++r)
            EXPECT_NEAR((*actual)[c][r], expected[c][r], tolerance)
                << "column " << c << " row " << r;
}

glm::dmat4 moved(double x, double y, double z) {
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

glm::dmat4 turned(double degrees, const glm::dvec3& axis = alongZ) {
    return glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis);
}

glm::dmat4 scaled(double x, double y, double z) {
    return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

/// A box rotated by these quaternions, the first at 0 and the last at 3 seconds.
std::optional<glm::dmat4> turnedBox(const std::vector<float>& quaternions, double seconds,
                                    const std::string& interpolation = "LINEAR") {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move(node, "rotation", {0, 3}, quaternions, interpolation);
    return scene.pose(node, seconds);
}

} // namespace

TEST(Animation, WhatDoesNotMoveHasNone) {
    MovingScene scene;
    const int node = scene.addBox();
    EXPECT_FALSE(scene.animation());
    scene.gltf.json["animations"] = Json::array({Json::object()});
    EXPECT_FALSE(scene.animation());
    scene.move<float>(node, "weights", {0, 1}, {0, 0, 0, 0, 0, 0});
    EXPECT_FALSE(scene.animation());
}

TEST(Animation, ChannelsOfExtensionsAreLeftAside) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "translation", {0, 1}, {0, 0, 0, 1, 2, 3});
    scene.move<float>(node, "scale", {0, 9}, {0, 0, 0, 0, 0, 0});
    scene.move<float>(node, "scale", {0, 9}, {0, 0, 0, 0, 0, 0});
    Json& channels = scene.gltf.json["animations"][0]["channels"];
    const Json pointer = {{"KHR_animation_pointer", {{"pointer", "/materials/0/alphaCutoff"}}}};
    channels[1]["target"] = {{"path", "pointer"}, {"extensions", pointer}};
    channels[2]["target"] = {{"node", node}, {"path", "odd"}, {"extensions", pointer}};
    expectMatrix(scene.pose(node, 1.0), moved(1, 2, 3));
    EXPECT_EQ(scene.animation()->duration, 1.0);
}

TEST(Animation, ItsDurationIsItsLastKeyframe) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "translation", {0.5f, 1.5f}, {0, 0, 0, 0, 0, 0});
    scene.move<float>(node, "scale", {0.25f, 2.25f, 4.75f}, {1, 1, 1, 1, 1, 1, 1, 1, 1});
    EXPECT_EQ(scene.animation()->duration, 4.75);
}

TEST(Animation, TheFirstOfSeveralIsTaken) {
    MovingScene scene;
    const int first = scene.addBox();
    const int second = scene.addBox({{"translation", {0, 5, 0}}});
    scene.move<float>(first, "translation", {0}, {1, 0, 0});
    EXPECT_EQ(scene.animation()->motions.size(), 1u);
    EXPECT_TRUE(scene.warnings.sentences().empty());

    scene.move<float>(first, "translation", {0}, {2, 0, 0}, "", 1);
    scene.move<float>(second, "translation", {0}, {3, 0, 0}, "", 1);
    expectMatrix(scene.pose(first, 0.0), moved(1, 0, 0));
    expectMatrix(scene.pose(second, 0.0), moved(0, 5, 0)); // its own batch, at rest
    EXPECT_TRUE(scene.warnings.sentences().empty());
    EXPECT_EQ(scene.animation(1)->motions.size(), 2u);
}

TEST(Animation, AnAnimationOfNoNodesIsPassedOver) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "weights", {0, 1}, {0, 0, 0, 0, 0, 0});
    scene.move<float>(node, "translation", {0}, {2, 0, 0}, "", 1);
    expectMatrix(scene.pose(node, 0.0), moved(2, 0, 0));
    EXPECT_TRUE(scene.warnings.sentences().empty());
}

TEST(Animation, AStepHoldsUntilTheNextKeyframe) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "translation", {1, 2, 4}, {1, 0, 0, 2, 0, 0, 3, 0, 0}, "STEP");
    const std::pair<double, double> expected[] = {{0.0, 1.0},   {1.0, 1.0}, {1.999, 1.0},
                                                  {2.0, 2.0},   {3.9, 2.0}, {4.0, 3.0},
                                                  {1e300, 3.0}, {-5.0, 1.0}};
    for (const auto& [seconds, x] : expected)
        expectMatrix(scene.pose(node, seconds), moved(x, 0, 0), 0.0);
}

TEST(Animation, LinearVectorsGoStraight) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "translation", {1, 2, 4}, {0, 0, 0, 4, 8, 0, 4, 0, 2}, "LINEAR");
    expectMatrix(scene.pose(node, 1.25), moved(1, 2, 0));
    expectMatrix(scene.pose(node, 2.0), moved(4, 8, 0), 0.0);
    expectMatrix(scene.pose(node, 3.5), moved(4, 2, 1.5));
    expectMatrix(scene.pose(node, 0.0), moved(0, 0, 0), 0.0);
    expectMatrix(scene.pose(node, 9.0), moved(4, 0, 2), 0.0);
}

TEST(Animation, LinearIsTheDefault) {
    MovingScene scene;
    const int node = scene.addBox();
    scene.move<float>(node, "scale", {0, 1}, {1, 1, 1, 3, 5, 7});
    expectMatrix(scene.pose(node, 0.5), scaled(2, 3, 4));
}

TEST(Animation, LinearRotationsKeepTheirSpeed) {
    const std::vector<float> quarterTurn = {0, 0, 0, 1, 0, 0, root, root};
    expectMatrix(turnedBox(quarterTurn, 1.0), turned(30));
    expectMatrix(turnedBox(quarterTurn, 2.0), turned(60));
    expectMatrix(turnedBox(quarterTurn, 3.0), turned(90));
}

TEST(Animation, LinearRotationsTakeTheShorterWay) {
    // The same rotation as above, by the opposite quaternion.
    expectMatrix(turnedBox({0, 0, 0, 1, 0, 0, -root, -root}, 1.0), turned(30));
}

TEST(Animation, QuaternionsNeedNotBeOfUnitLength) {
    expectMatrix(turnedBox({0, 0, 0, 5, 0, 0, 0.25f, 0.25f}, 1.0), turned(30));
    expectMatrix(turnedBox({0, 0, 1e-30f, 1e-30f, 0, 0, 0, 1}, 0.0, "STEP"), turned(90));
}

TEST(Animation, OppositeQuaternionsAreNoTurn) {
    expectMatrix(turnedBox({0, 0, 0, 1, 0, 0, 0, -1}, 1.5), glm::dmat4(1.0));
}

TEST(Animation, SplinesFollowTheirTangents) {
    // At the middle: half of both values, an eighth of the tangents times the 2 seconds.
    MovingScene scene;
    const int node = scene.addBox();
    const std::vector<float> values = {9,  9, 9, /**/ 0, 0, 0, /**/ 8, 0, 4,
                                       -8, 4, 0, /**/ 4, 2, 0, /**/ 9, 9, 9};
    scene.move(node, "translation", {1, 3}, values, "CUBICSPLINE");
    expectMatrix(scene.pose(node, 2.0), moved(2 + 2 + 2, 1 - 1, 1));
    // A quarter: 27/32 and 5/32 of the values, 9/64 and -3/64 of the tangents times 2.
    expectMatrix(scene.pose(node, 1.5), moved(4 * 5 / 32. + 2 * (8 * 9 / 64. + 8 * 3 / 64.),
                                              2 * 5 / 32. - 2 * 4 * 3 / 64., 2 * 4 * 9 / 64.));
    expectMatrix(scene.pose(node, 1.0), moved(0, 0, 0), 0.0);
    expectMatrix(scene.pose(node, 3.0), moved(4, 2, 0), 0.0);
    expectMatrix(scene.pose(node, 0.0), moved(0, 0, 0), 0.0);
    expectMatrix(scene.pose(node, 7.0), moved(4, 2, 0), 0.0);
}

TEST(Animation, SplinesOfRotationsAreNormalised) {
    const std::vector<float> still = {0, 0, 0, 0, /**/ 0, 0, 0,    1,    /**/ 0, 0, 0, 0,
                                      0, 0, 0, 0, /**/ 0, 0, root, root, /**/ 0, 0, 0, 0};
    expectMatrix(turnedBox(still, 1.5, "CUBICSPLINE"), turned(45));
    // A third: 20/27 of the first, 7/27 of the second.
    const double turn = std::atan2(7 * root, 20 + 7 * root) / 3.14159265358979323846 * 360.0;
    expectMatrix(turnedBox(still, 1.0, "CUBICSPLINE"), turned(turn));
}

TEST(Animation, ASplineThroughZeroStaysFinite) {
    const std::vector<float> through = {0, 0, 0, 0, /**/ 0, 0, 0, 1,  /**/ 0, 0, 0, 0,
                                        0, 0, 0, 0, /**/ 0, 0, 0, -1, /**/ 0, 0, 0, 0};
    expectMatrix(turnedBox(through, 1.5, "CUBICSPLINE"), glm::dmat4(1.0));
}

TEST(Animation, RotationsMayBeNormalisedIntegers) {
    const auto pose = [](const auto& values) {
        MovingScene scene;
        const int node = scene.addBox();
        scene.move(node, "rotation", {0, 3}, values);
        return scene.pose(node, 1.0);
    };
    expectMatrix(pose(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 23170, 23170}), turned(30));
    expectMatrix(pose(std::vector<std::uint16_t>{0, 0, 0, 65535, 0, 0, 46340, 46340}), turned(30));
    expectMatrix(pose(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, -90, 90}), turned(-30));
    expectMatrix(pose(std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 180, 180}), turned(30));
}

TEST(Animation, WhatHasNoChannelStaysAtRest) {
    MovingScene scene;
    const int node = scene.addBox({{"translation", {1, 2, 3}},
                                   {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                                   {"scale", {2, 3, 4}}});
    scene.move<float>(node, "translation", {0}, {7, 8, 9});
    expectMatrix(scene.pose(node, 0.0), moved(7, 8, 9) * turned(90) * scaled(2, 3, 4));
    scene.move<float>(node, "scale", {0}, {-1, 5, 6});
    expectMatrix(scene.pose(node, 0.0), moved(7, 8, 9) * turned(90) * scaled(-1, 5, 6));
    scene.move<float>(node, "rotation", {0}, {root, 0, 0, root});
    expectMatrix(scene.pose(node, 0.0), moved(7, 8, 9) * turned(90, {1, 0, 0}) * scaled(-1, 5, 6));
}

TEST(Animation, AtRestEverythingIsWhereItWas) {
    MovingScene scene;
    const int leaf = scene.addBox({{"translation", {1, 2, 3}}, {"scale", {1, -2, 0.5}}}, false);
    const int between = scene.gltf.addNode(
        {{"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 0, 0, 1}}, {"children", {leaf}}},
        false);
    const int top = scene.addBox(
        {{"rotation", {0, 0, 0.6, 0.8}}, {"translation", {-7, 0, 2}}, {"children", {between}}},
        false);
    scene.gltf.addNode({{"translation", {1e6, 0, 0}}, {"children", {top}}});
    scene.addBox();
    scene.move<float>(leaf, "translation", {0, 1}, {1, 2, 3, 9, 9, 9});
    scene.move<float>(leaf, "scale", {0, 1}, {1, -2, 0.5f, 9, 9, 9});
    scene.move<float>(top, "rotation", {0, 1}, {0, 0, 0.6f, 0.8f, 1, 0, 0, 0});
    scene.move<float>(top, "translation", {0, 1}, {-7, 0, 2, 9, 9, 9});
    const Scene flat = scene.scene();
    ASSERT_EQ(flat.batches.size(), 3u);
    const auto pose = poseAt(scene.animation().value(), flat, 0.0).worldFromBatch;
    for (std::size_t b = 0; b < 3; ++b)
        expectMatrix(pose[b], flat.batches[b].worldFromBatch, 1e-5);
    EXPECT_EQ(flat.batches[0].node, -1);
    for (const double seconds : {0.0, 0.3, 1.0, 50.0})
        EXPECT_EQ(poseAt(scene.animation().value(), flat, seconds).worldFromBatch[0],
                  flat.batches[0].worldFromBatch);
}

TEST(Animation, AnimatedNodesBelowOthersFollowThem) {
    MovingScene scene;
    const int leaf = scene.addBox({{"scale", {2, 2, 2}}}, false);
    const int between = scene.gltf.addNode(
        {{"translation", {3, 0, 0}}, {"scale", {1, 1, 5}}, {"children", {leaf}}}, false);
    const int top = scene.addBox({{"children", {between}}}, false);
    scene.gltf.addNode({{"translation", {0, 0, 100}}, {"children", {top}}});
    scene.move<float>(leaf, "translation", {0, 1}, {0, 0, 0, 4, 0, 0});
    scene.move<float>(top, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, root, root});
    expectMatrix(scene.pose(top, 1.0), moved(0, 0, 100) * turned(90));
    expectMatrix(scene.pose(leaf, 1.0), moved(0, 0, 100) * turned(90) * moved(3, 0, 0) *
                                            scaled(1, 1, 5) * moved(4, 0, 0) * scaled(2, 2, 2));
    // 3 + 4 along x, rotated to y.
    EXPECT_NEAR((*scene.pose(leaf, 1.0))[3].y, 7.0, 1e-6);
}

TEST(Animation, AMoverThatCarriesNoMeshMovesThoseBelow) {
    MovingScene scene;
    const int leaf = scene.addBox({{"translation", {1, 0, 0}}}, false);
    const int top = scene.gltf.addNode({{"children", {leaf}}});
    scene.move<float>(top, "rotation", {0}, {0, 0, root, root});
    scene.move<float>(leaf, "scale", {0}, {3, 3, 3}, "", 1); // from another animation: at rest
    expectMatrix(scene.pose(leaf, 0.0), turned(90) * moved(1, 0, 0));
}

TEST(Animation, TheLocalOriginIsKept) {
    MovingScene scene;
    const int far = scene.addBox({{"translation", {1e6, 0, 0}}}, false);
    const int top = scene.gltf.addNode({{"children", {far}}});
    scene.move<float>(top, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0});
    const Scene flat = scene.scene();
    ASSERT_EQ(flat.batches.size(), 1u);
    EXPECT_EQ(glm::dvec3(flat.batches[0].nodeFromBatch[3]), glm::dvec3(1e6, 0, 0));
    expectMatrix(scene.pose(top, 0.0), flat.batches[0].worldFromBatch, 0.0);
    expectMatrix(scene.pose(top, 1.0), moved(-1e6, 0, 0) * turned(180), 1e-3);
}

TEST(Animation, WhatIsScaledToNothingIsNotDrawn) {
    MovingScene scene;
    const int leaf = scene.addBox(Json::object(), false);
    const int top = scene.addBox({{"children", {leaf}}});
    const int other = scene.addBox();
    scene.move<float>(top, "scale", {0, 1, 2}, {1, 1, 1, 1, 0, 1, 2, 2, 2}, "STEP");
    scene.move<float>(leaf, "translation", {0}, {1, 0, 0});
    scene.move<float>(other, "translation", {0}, {1, 0, 0});
    EXPECT_TRUE(scene.pose(top, 0.0));
    EXPECT_FALSE(scene.pose(top, 1.0));
    EXPECT_FALSE(scene.pose(leaf, 1.0));
    EXPECT_TRUE(scene.pose(other, 1.0));
    expectMatrix(scene.pose(leaf, 2.0), scaled(2, 2, 2) * moved(1, 0, 0));
}

TEST(Animation, WhatLeavesTheRangeOfFloatsIsNotDrawn) {
    MovingScene scene;
    const int leaf = scene.addBox(Json::object(), false);
    const int top = scene.addBox({{"children", {leaf}}});
    const float most = 3e38f;
    const float least = 1e-42f;
    scene.move<float>(top, "scale", {0, 1, 2}, {1, 1, 1, most, most, most, least, least, least});
    scene.move<float>(leaf, "translation", {0, 1}, {0, 0, 0, 9, 0, 0});
    EXPECT_TRUE(scene.pose(top, 1.0));
    EXPECT_FALSE(scene.pose(leaf, 1.0)); // the matrix does not fit into floats
    EXPECT_FALSE(scene.pose(top, 2.0));  // its inverse does not fit
}

TEST(Animation, ANodeOutsideOfTheSceneMovesNothing) {
    MovingScene scene;
    scene.addBox();
    const int outside = scene.addBox(Json::object(), false);
    scene.move<float>(outside, "translation", {0, 1}, {0, 0, 0, 5, 0, 0});
    const Scene flat = scene.scene();
    const auto pose = poseAt(scene.animation().value(), flat, 1.0).worldFromBatch;
    ASSERT_EQ(pose.size(), 1u);
    EXPECT_EQ(pose[0], flat.batches[0].worldFromBatch);
}

TEST(Animation, LightsAndCamerasGoWithTheirNodes) {
    MovingScene scene;
    const std::string lights = "KHR_lights_punctual";
    scene.gltf.useExtension(lights);
    scene.gltf.json["extensions"][lights]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}},
                                                       {{"type", "directional"}}};
    scene.gltf.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    const auto lit = [&](int light) { return Json({{lights, {{"light", light}}}}); };
    const int lamp = scene.gltf.addNode(
        {{"translation", {0, 3, 0}}, {"camera", 0}, {"extensions", lit(0)}}, false);
    const int arm = scene.addBox({{"children", {lamp}}});
    const int sun = scene.gltf.addNode({{"extensions", lit(1)}});
    scene.gltf.addNode({{"translation", {0.1, 0.2, 0.3}}, {"extensions", lit(0)}}); // static
    scene.move<float>(arm, "rotation", {0, 1}, {0, 0, 0, 1, 0, root, 0, root});     // about y
    scene.move<float>(arm, "translation", {0, 1}, {0, 0, 0, 5, 0, 0});
    scene.move<float>(sun, "rotation", {0, 1}, {0, 0, 0, 1, -root, 0, 0, root}); // about -x

    Scene flat = scene.scene();
    ASSERT_EQ(flat.lights.size(), 3u);
    const Pose pose = poseAt(scene.animation().value(), flat, 1.0);
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::distance(a, b) < 1e-6;
    };
    EXPECT_EQ(flat.lights[0].position, glm::dvec3(0, 3, 0));
    EXPECT_TRUE(near(pose.lights[0].position, {5, 3, 0}));
    EXPECT_TRUE(near(pose.lights[0].direction, {-1, 0, 0}));
    EXPECT_TRUE(near(pose.lights[1].direction, {0, -1, 0}));
    EXPECT_EQ(pose.lights[2].position, flat.lights[2].position);
    ASSERT_EQ(pose.cameras.size(), 1u);
    expectMatrix(pose.cameras[0].worldFromCamera, moved(5, 3, 0) * turned(90, {0, 1, 0}));

    place(flat, pose);
    EXPECT_EQ(flat.lights[0].position, pose.lights[0].position);
    EXPECT_EQ(flat.cameras[0].worldFromCamera, pose.cameras[0].worldFromCamera);
    expectMatrix(flat.batches[0].worldFromBatch, moved(5, 0, 0) * turned(90, {0, 1, 0}));
}

TEST(Animation, LightsWithoutAPlaceStayWhereTheyWere) {
    MovingScene scene;
    const std::string lights = "KHR_lights_punctual";
    scene.gltf.useExtension(lights);
    scene.gltf.json["extensions"][lights]["lights"] = {
        {{"type", "point"}}, {{"type", "spot"}, {"spot", Json::object()}}};
    std::vector<int> nodes;
    for (int light = 0; light < 2; ++light)
        nodes.push_back(scene.gltf.addNode(
            {{"translation", {1, 2, 3}}, {"extensions", {{lights, {{"light", light}}}}}}));
    for (const int node : nodes) {
        scene.move<float>(node, "scale", {0, 1}, {1, 1, 1, 0, 0, 0});
        scene.move<float>(node, "translation", {0, 1, 2}, {1, 2, 3, 4, 5, 6, 3e38f, 0, 0});
    }
    const Scene flat = scene.scene();
    const Animation animation = scene.animation().value();
    const Pose none = poseAt(animation, flat, 1.0), far = poseAt(animation, flat, 2.0);
    EXPECT_EQ(none.lights[0].position, glm::dvec3(4, 5, 6)) << "a point light needs no turn";
    EXPECT_EQ(none.lights[1].position, glm::dvec3(4, 5, 6)) << "a spot's is that of its rotation";
    EXPECT_EQ(none.lights[1].direction, glm::dvec3(0, 0, -1));
    EXPECT_EQ(far.lights[0].position, glm::dvec3(1, 2, 3));
}

TEST(Animation, WhatIsScaledToNothingAtRestAppearsWhenItGrows) {
    for (const Json& rest : {Json{0, 0, 0}, Json{1, 0, 1}, Json{0, 1, 1}, Json{0, 0, 1}}) {
        MovingScene scene;
        const int child = scene.addBox({{"translation", {1, 0, 0}}}, false);
        const int moving = scene.addBox({{"translation", {2, 0, 0}}}, false);
        const int top = scene.addBox({{"scale", rest}, {"children", {child, moving}}});
        scene.move<float>(top, "scale", {0, 1}, {0, 0, 0, 2, 2, 2}, "STEP");
        scene.move<float>(moving, "translation", {0}, {0, 3, 0});
        Scene flat = scene.scene();
        EXPECT_TRUE(flat.warnings.sentences().empty());
        ASSERT_EQ(flat.batches.size(), 2u) << "the child goes with the one above";
        EXPECT_TRUE(worldBounds(flat).empty()) << rest;
        for (const Batch& batch : flat.batches) {
            EXPECT_TRUE(batch.hidden);
            EXPECT_NE(glm::determinant(glm::dmat3(batch.worldFromBatch)), 0.0);
        }
        EXPECT_FALSE(scene.pose(top, 0.5));
        expectMatrix(scene.pose(top, 1.0), scaled(2, 2, 2));
        expectMatrix(scene.pose(moving, 1.0), scaled(2, 2, 2) * moved(0, 3, 0));
        place(flat, poseAt(scene.animation().value(), flat, 1.0));
        EXPECT_FALSE(flat.batches[0].hidden);
        EXPECT_FALSE(worldBounds(flat).empty());
    }
}

TEST(Animation, WhatNoAnimationScalesIsFlatForGood) {
    // The same for a sheet, a box scaled by 0, that moves and rotates.
    for (const bool other : {false, true}) {
        MovingScene scene;
        const int sheet = scene.addBox({{"scale", {1, 0, 1}}});
        scene.move<float>(sheet, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "STEP");
        if (other) scene.move<float>(sheet, "rotation", {0, 1}, {0, 0, 0, 1, root, 0, 0, root});
        Scene flat = scene.scene();
        ASSERT_EQ(flat.batches.size(), 1u);
        EXPECT_FALSE(flat.batches[0].hidden);
        EXPECT_EQ(worldBounds(flat).low, glm::dvec3(-1, 0, -1));
        EXPECT_EQ(worldBounds(flat).high, glm::dvec3(1, 0, 1));
        place(flat, poseAt(scene.animation().value(), flat, 1.0));
        EXPECT_FALSE(flat.batches[0].hidden);
        const glm::dvec3 size = other ? glm::dvec3(1, 1, 0) : glm::dvec3(1, 0, 1);
        EXPECT_LT(glm::distance(worldBounds(flat).low, glm::dvec3(5, 0, 0) - size), 1e-6);
        EXPECT_LT(glm::distance(worldBounds(flat).high, glm::dvec3(5, 0, 0) + size), 1e-6);
    }
}

TEST(Animation, WhatIsFlatButForRoundingIsNotDrawn) {
    MovingScene scene;
    const int leaf = scene.addBox({{"rotation", {0.1, 0.2, 0.3, std::sqrt(0.86)}}}, false);
    const int middle = scene.gltf.addNode({{"children", {leaf}}, {"scale", {1, 0, 1}}}, false);
    const int top = scene.gltf.addNode(
        {{"children", {middle}}, {"rotation", {0.3, 0.1, 0.2, std::sqrt(0.86)}}});
    scene.move<float>(leaf, "translation", {0}, {1, 2, 3});
    scene.move<float>(middle, "scale", {0, 1}, {1, 0, 1, 1, 1e-6f, 1});
    scene.move<float>(top, "translation", {0}, {0, 0, 4});
    EXPECT_FALSE(scene.pose(leaf, 0.0));
    EXPECT_TRUE(scene.pose(leaf, 1.0)) << "it is thin, not flat";
}

TEST(Animation, CamerasAndLightsOfNodesScaledToNothingHaveTheirTurns) {
    MovingScene scene;
    const std::string lights = "KHR_lights_punctual";
    scene.gltf.useExtension(lights);
    scene.gltf.json["extensions"][lights]["lights"] = {{{"type", "directional"}}};
    scene.gltf.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    const int lamp = scene.addBox({{"rotation", {0, root, 0, root}}, // about y
                                   {"scale", {0, 0, 0}},
                                   {"camera", 0},
                                   {"extensions", {{lights, {{"light", 0}}}}}});
    scene.move<float>(lamp, "rotation", {0, 1}, {0, root, 0, root, -root, 0, 0, root});
    const Scene flat = scene.scene();
    EXPECT_TRUE(flat.warnings.sentences().empty());
    const Pose pose = poseAt(scene.animation().value(), flat, 1.0);
    EXPECT_LT(glm::distance(flat.lights.at(0).direction, {-1, 0, 0}), 1e-6);
    EXPECT_LT(glm::distance(pose.lights.at(0).direction, {0, -1, 0}), 1e-6);
    expectMatrix(flat.cameras.at(0).worldFromCamera, turned(90, {0, 1, 0}));
    expectMatrix(pose.cameras.at(0).worldFromCamera, turned(-90, {1, 0, 0}));
}

} // namespace edgeshade::test
