// Cameras of a file: their placement by nodes, their view, and how they are found.
#include "src/shadow/view/scene_cameras.hpp"

#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade::test {
namespace {

Json perspective(double yfov) {
    return {{"type", "perspective"},
            {"name", "wide"},
            {"perspective", {{"yfov", yfov}, {"znear", 0.5}, {"zfar", 2.0}, {"aspectRatio", 3.0}}}};
}

Json orthographic(double ymag) {
    return {{"type", "orthographic"},
            {"orthographic", {{"xmag", 7.0}, {"ymag", ymag}, {"znear", 0.0}, {"zfar", 1.0}}}};
}

/// A box, and cameras placed by these nodes.
Scene sceneWith(const Json& cameras, const std::vector<Json>& nodes) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json["cameras"] = cameras;
    for (const Json& node : nodes)
        gltf.addNode(node);
    return sceneOf(gltf);
}

SceneCamera cameraUnder(Json node, const Json& camera = perspective(1.0)) {
    node["camera"] = 0;
    const Scene scene = sceneWith(Json::array({camera}), {node});
    EXPECT_TRUE(scene.warnings.sentences().empty());
    return scene.cameras.at(0);
}

/// Position of a point in the picture, from -1 to 1 in both directions.
glm::dvec2 projected(const Frustum& frustum, const glm::dvec3& point) {
    const glm::dvec4 clip =
        clipFromView(frustum, 0.01, 100.0) * frustum.viewFromWorld * glm::dvec4(point, 1.0);
    return glm::dvec2(clip) / clip.w;
}

void expectAt(const glm::dvec2& found, const glm::dvec2& wanted) {
    EXPECT_LT(glm::distance(found, wanted), 1e-12)
        << found.x << ", " << found.y << " is not " << wanted.x << ", " << wanted.y;
}

const Json turnedAroundY = {0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5)}; // 90 degrees: looks along -x

} // namespace

TEST(SceneCameras, APerspectiveOneSeesItsHeightAtThePicturesAspect) {
    const double yfov = 2.0 * std::atan(0.5);
    const SceneCamera camera =
        cameraUnder({{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}}, perspective(yfov));
    const Frustum frustum = frustumOf(camera, 2.0);
    // At depth 4 the picture is 4 high and 8 wide; right is -z.
    expectAt(projected(frustum, {1, 1, 0}), {0, 0});
    expectAt(projected(frustum, {1, 3, 0}), {0, 1});
    expectAt(projected(frustum, {1, 1, -4}), {1, 0});
    expectAt(projected(frustum, {1, 0, 2}), {-0.5, -0.5});
}

TEST(SceneCameras, AnOrthographicOneIsTwiceItsYmagHigh) {
    for (const double ymag : {1.5, -1.5}) {
        const SceneCamera camera = cameraUnder({{"translation", {0, 0, 9}}}, orthographic(ymag));
        EXPECT_TRUE(camera.orthographic);
        const Frustum frustum = frustumOf(camera, 2.0);
        expectAt(projected(frustum, {0, 1.5, -30}), {0, 1});
        expectAt(projected(frustum, {-3, 0, 2}), {-1, 0});
    }
}

TEST(SceneCameras, ScaleAndMirroringOfNodesAreIgnored) {
    const SceneCamera plain =
        cameraUnder({{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}});
    for (const Json& scale : {Json{2, 2, 2}, Json{1, 3, 0.5}, Json{-1, 1, 1}, Json{1e-9, 1e9, 1},
                              Json{1, 0, 1}, Json{1, 1, 0}, Json{0, 0, 0}}) {
        const SceneCamera scaled = cameraUnder(
            {{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}, {"scale", scale}});
        for (glm::length_t c = 0; c < 4; ++c)
            EXPECT_LT(glm::distance(scaled.worldFromCamera[c], plain.worldFromCamera[c]), 1e-12)
                << scale << ", column " << c;
    }
}

TEST(SceneCameras, AShearedNodeLeavesARightAngle) {
    const SceneCamera camera =
        cameraUnder({{"matrix", {1, 0, 0, 0, 0.5, 1, 0.7, 0, 0, 0, 1, 0, 1, 2, 3, 1}}});
    const glm::dmat3 turn(camera.worldFromCamera);
    EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-12);
    EXPECT_LT(glm::distance(turn[2], {0, 0, 1}), 1e-12);
    EXPECT_LT(glm::distance(turn[1], glm::normalize(glm::dvec3(0.5, 1, 0))), 1e-12);
}

TEST(SceneCameras, AreThoseOfTheScenesNodesInTheirOrder) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json["cameras"] = {perspective(1.0), orthographic(2.0)};
    const int child = gltf.addNode({{"camera", 1}, {"name", "above"}}, false);
    gltf.addNode({{"camera", 0}, {"name", "nowhere"}}, false);
    gltf.addNode({{"children", {child}}, {"translation", {0, 7, 0}}});
    gltf.addNode({{"camera", 0},
                  {"name", "hidden"},
                  {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].nodeName, "above");
    EXPECT_EQ(scene.cameras[0].worldFromCamera[3], glm::dvec4(0, 7, 0, 1));
    EXPECT_EQ(scene.cameras[1].name, "wide");
    EXPECT_EQ(scene.cameras[1].nodeName, "hidden");
    EXPECT_TRUE(scene.warnings.sentences().empty());
}

TEST(SceneCameras, AreFoundByNameThenNodeThenIndex) {
    std::vector<SceneCamera> cameras(4);
    cameras[0].name = "front";
    cameras[1].nodeName = "front";
    cameras[2].nodeName = "back";
    cameras[3].name = "0";
    const auto indexOf = [&](const std::string& text) {
        const SceneCamera* found = findCamera(cameras, text);
        return found ? found - cameras.data() : -1;
    };
    EXPECT_EQ(indexOf("front"), 0);
    EXPECT_EQ(indexOf("back"), 2);
    EXPECT_EQ(indexOf("1"), 1);
    EXPECT_EQ(indexOf("0"), 3) << "names come first";
    for (const char* text : {"", "4", "-1", "1 ", "+1", "1.0", "99999999999999999999", "side"})
        EXPECT_EQ(indexOf(text), -1) << text;
    EXPECT_EQ(titleOf(cameras, 2), "back");
    EXPECT_EQ(titleOf({SceneCamera()}, 0), "0");
}

TEST(SceneCameras, OneToOrbitFromLooksTheSameWay) {
    const SceneCamera camera =
        cameraUnder({{"translation", {5, 1, 0}}, {"rotation", turnedAroundY}});
    const Camera upright = uprightCamera(camera, {glm::dvec3(-1.0), glm::dvec3(1.0)});
    EXPECT_EQ(upright.from, glm::dvec3(5, 1, 0));
    EXPECT_LT(glm::distance(upright.to, {0, 1, 0}), 1e-12);
    EXPECT_NEAR(upright.fovDegrees, 180.0 / std::numbers::pi, 1e-12);
    const Camera beside = uprightCamera(camera, {glm::dvec3(9.0), glm::dvec3(10.0)});
    EXPECT_LT(beside.to.x, 5.0) << "what is behind it is nothing to look at";
}

/// The warning if one of two cameras is broken.
std::string warnedOf(const Json& node, const Json& camera) {
    Json broken = node;
    broken["camera"] = 1;
    const Scene scene =
        sceneWith(Json::array({perspective(1.0), camera}), {broken, {{"camera", 0}}});
    EXPECT_EQ(scene.cameras.size(), 1u) << "the other one is there";
    EXPECT_EQ(scene.warnings.sentences().size(), 1u);
    return scene.warnings.sentences().empty() ? "" : scene.warnings.sentences()[0];
}

TEST(SceneCameras, BrokenOnesAreLeftOut) {
    const auto expectWords = [](const std::string& said, const std::string& words) {
        EXPECT_NE(said.find(words), std::string::npos) << said;
        EXPECT_NE(said.find("; the camera is left out."), std::string::npos) << said;
    };
    const Json plain = Json::object();
    expectWords(warnedOf(plain, perspective(3.2)), "cameras[1].perspective.yfov is 3.2");
    expectWords(warnedOf(plain, perspective(-1.0)), "cameras[1].perspective.yfov is -1.0");
    expectWords(warnedOf(plain, orthographic(1e300)), "cameras[1].orthographic.ymag");
    expectWords(warnedOf(plain, orthographic(0.0)), "cameras[1].orthographic.ymag is 0.0");
    const Json flat = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    expectWords(warnedOf({{"matrix", flat}}, orthographic(1.0)), "nodes[1].camera");
    expectWords(warnedOf({{"translation", {1e300, 0, 0}}}, orthographic(1.0)), "nodes[1].camera");
}

} // namespace edgeshade::test
