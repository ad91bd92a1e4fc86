// Invalid keyframes: the channel is left out, or played if its data have only one meaning, with one
// warning that names the field and the value. Indices and words are checked earlier:
// tests/cli/bad_animations.cpp.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace edgeshade::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
const char* const input = "animations[0].samplers[0].input";
const char* const output = "animations[0].samplers[0].output";

/// An animated box, with samplers[0] to be tampered with.
struct AnimatedBox {
    GltfBuilder gltf;

    explicit AnimatedBox(const std::string& path = "translation") {
        gltf.animate(gltf.addShapeNode(box(glm::vec3(1.0f))), path);
    }
    Json& sampler() { return gltf.json["animations"][0]["samplers"][0]; }
    Json& channel() { return gltf.json["animations"][0]["channels"][0]; }
    /// Adds a second, sound channel behind the one to be tampered with.
    void addRotation() {
        gltf.animate(0, "rotation");
        Json& animations = gltf.json["animations"];
        animations[0]["samplers"].push_back(Json(animations[1]["samplers"][0]));
        animations[0]["channels"].push_back(Json(animations[1]["channels"][0]));
        animations[0]["channels"][1]["sampler"] = 1;
        animations.erase(1);
    }
    Json& accessor(const char* key) { return gltf.json["accessors"][sampler()[key].get<int>()]; }
    template <class T>
    void setTimes(const std::vector<T>& times) {
        sampler()["input"] = gltf.addArray(times, 1);
    }
    template <class T>
    void setValues(const std::vector<T>& values, int components,
                   const Json& more = Json::object()) {
        sampler()["output"] = gltf.addArray(values, components, more);
    }
    struct Reading {
        std::optional<Animation> animation;
        std::vector<std::string> warnings;
    };
    Reading read() const {
        const GltfDocument document = parseGltf(gltf.glb(), "test.glb");
        Warnings warnings = document.warnings;
        auto animation = readAnimation(document, warnings);
        return {std::move(animation), warnings.sentences()};
    }
    /// Expects the warning, no animation, and the box in its rest pose.
    void expectLeftOut(std::initializer_list<const char*> words) const {
        const Reading reading = read();
        EXPECT_FALSE(reading.animation);
        ASSERT_EQ(reading.warnings.size(), 1u);
        const std::string& warning = reading.warnings[0];
        EXPECT_TRUE(warning.ends_with("; the channel is left out.")) << warning;
        EXPECT_NE(warning.find("'test.glb'"), std::string::npos) << warning;
        for (const char* word : words)
            EXPECT_NE(warning.find(word), std::string::npos)
                << "'" << word << "' is missing from: " << warning;
        GltfBuilder still = gltf;
        still.json.erase("animations");
        expectSameTriangles(worldTriangles(sceneOf(gltf)), worldTriangles(sceneOf(still)), 1e-6);
    }
    /// Expects the warning, and these positions along x at these times.
    void expectPlayed(std::initializer_list<const char*> words,
                      const std::vector<std::pair<double, double>>& places) const {
        const Reading reading = read();
        ASSERT_TRUE(reading.animation);
        ASSERT_EQ(reading.warnings.size(), 1u);
        for (const char* word : words)
            EXPECT_NE(reading.warnings[0].find(word), std::string::npos)
                << "'" << word << "' is missing from: " << reading.warnings[0];
        for (const auto& [seconds, x] : places)
            EXPECT_NEAR(reading.animation->motions.at(0).at(seconds).translation.x, x, 1e-5)
                << seconds << " s";
    }
    void expectSound() const {
        const Reading reading = read();
        EXPECT_TRUE(reading.animation);
        EXPECT_TRUE(reading.warnings.empty());
    }
};

void expectTimesLeftOut(const std::vector<float>& times, std::initializer_list<const char*> words) {
    AnimatedBox scene;
    scene.setTimes(times);
    scene.expectLeftOut({input});
    scene.expectLeftOut(words);
}

} // namespace

TEST(BadAnimation, TheSceneOfTheseTestsIsSound) {
    AnimatedBox("translation").expectSound();
    AnimatedBox("rotation").expectSound();
    AnimatedBox("scale").expectSound();
}

TEST(BadAnimation, TimesMustNotDecrease) {
    expectTimesLeftOut({0.0f, 2.0f, 1.5f}, {"holds 1.5 at element 2 after 2"});
}

TEST(BadAnimation, TimesAlikeAreAStep) {
    AnimatedBox scene;
    scene.setTimes<float>({0, 1, 1, 2});
    scene.setValues<float>({0, 0, 0, 2, 0, 0, 6, 0, 0, 8, 0, 0}, 3);
    scene.expectPlayed({input, "holds 1 at element 2 after 1", "jumps"},
                       {{0.5, 1.0}, {1.0 - 1e-9, 2.0}, {1.0, 6.0}, {1.5, 7.0}});
    AnimatedBox all;
    all.setTimes<float>({0.5f, 0.5f});
    all.setValues<float>({2, 0, 0, 6, 0, 0}, 3);
    all.expectPlayed({input, "0.5"}, {{0.0, 2.0}, {0.5, 6.0}, {1.0, 6.0}});
}

TEST(BadAnimation, OfNegativeTimesTheRestIsPlayed) {
    AnimatedBox scene;
    scene.setTimes<float>({-0.25f, 0.75f});
    scene.setValues<float>({0, 0, 0, 4, 0, 0}, 3);
    scene.expectPlayed({input, "-0.25", "from 0 on"}, {{0.0, 1.0}, {0.5, 3.0}, {2.0, 4.0}});
    scene.setTimes<float>({-2.0f, -1.0f});
    scene.expectPlayed({input, "-2"}, {{0.0, 4.0}, {1.0, 4.0}});
    EXPECT_EQ(scene.read().animation->duration, 0.0);
}

TEST(BadAnimation, TimesMustBeFinite) {
    expectTimesLeftOut({0.0f, infinity}, {"infinite", "element 1"});
    expectTimesLeftOut({notANumber, 1.0f}, {"NaN", "element 0"});
}

TEST(BadAnimation, TimesMustBeThere) {
    AnimatedBox scene;
    scene.accessor("input")["count"] = 0;
    scene.expectLeftOut({input, "no elements"});
}

TEST(BadAnimation, TimesMustBeScalarFloats) {
    AnimatedBox integers;
    integers.setTimes<std::uint16_t>({0, 1});
    integers.expectLeftOut({input, "5123", "must be SCALAR floats"});
    AnimatedBox vectors;
    vectors.sampler()["input"] = vectors.gltf.addArray<float>({0, 0, 1, 1}, 2);
    vectors.expectLeftOut({input, "VEC2", "must be SCALAR floats"});
}

TEST(BadAnimation, TimesMustLieWithinTheirView) {
    AnimatedBox scene;
    scene.accessor("input")["count"] = 1000;
    scene.expectLeftOut({input, "1000"});
}

TEST(BadAnimation, ClaimedTimesWithoutDataAreLeftOut) {
    AnimatedBox scene;
    scene.accessor("input").erase("bufferView");
    scene.accessor("input")["count"] = 1000000000;
    scene.expectLeftOut({input, "1000000000"});
}

TEST(BadAnimation, ClaimedValuesWithoutDataAreLeftOut) {
    AnimatedBox scene;
    scene.accessor("output").erase("bufferView");
    scene.accessor("output")["count"] = 1000000000;
    scene.expectLeftOut({output, "1000000000"});
}

TEST(BadAnimation, AValueATime) {
    AnimatedBox few;
    few.setValues(std::vector<float>(3), 3);
    few.expectLeftOut({output, "has 1 elements", "LINEAR with 2 times needs 2"});
    AnimatedBox many;
    many.setValues(std::vector<float>(9), 3);
    many.expectLeftOut({output, "has 3 elements", "needs 2"});
}

TEST(BadAnimation, ThreeValuesATimeOfASpline) {
    AnimatedBox scene;
    scene.sampler()["interpolation"] = "CUBICSPLINE";
    scene.expectLeftOut({output, "has 2 elements", "CUBICSPLINE with 2 times needs 6"});
}

TEST(BadAnimation, ASplineOfOneTimeHasItsValue) {
    for (const std::vector<float>& values :
         {std::vector<float>{9, 9, 9, 5, 0, 0, 9, 9, 9}, {5, 0, 0}}) {
        AnimatedBox scene;
        scene.sampler()["interpolation"] = "CUBICSPLINE";
        scene.setTimes<float>({0.5f});
        scene.setValues(values, 3);
        scene.expectPlayed({input, "1 element", "CUBICSPLINE"}, {{0.0, 5.0}, {1.0, 5.0}});
    }
}

TEST(BadAnimation, ValuesMustBeFinite) {
    AnimatedBox scene;
    scene.setValues<float>({0, 0, 0, 0, infinity, 0}, 3);
    scene.expectLeftOut({output, "infinite", "element 1"});
    AnimatedBox turning("rotation");
    turning.setValues<float>({notANumber, 0, 0, 1, 0, 0, 0, 1}, 4);
    turning.expectLeftOut({output, "NaN", "element 0"});
}

TEST(BadAnimation, TranslationsAndScalesMustBeVectorsOfFloats) {
    for (const char* path : {"translation", "scale"}) {
        AnimatedBox wide(path);
        wide.setValues(std::vector<float>(8), 4);
        wide.expectLeftOut({output, "VEC4", "must be VEC3 floats"});
        AnimatedBox small(path);
        small.setValues(std::vector<std::int16_t>(6), 3, {{"normalized", true}});
        small.expectLeftOut({output, "normalized componentType 5122", "must be VEC3 floats"});
    }
}

TEST(BadAnimation, RotationsMustBeQuaternions) {
    AnimatedBox narrow("rotation");
    narrow.setValues(std::vector<float>(6), 3);
    narrow.expectLeftOut({output, "VEC3", "must be VEC4"});
    AnimatedBox wide("rotation");
    wide.setValues(std::vector<std::uint32_t>(8, 1), 4, {{"normalized", true}});
    wide.expectLeftOut({output, "5125"});
    AnimatedBox plainIntegers("rotation");
    plainIntegers.setValues(std::vector<std::int8_t>(8, 1), 4);
    plainIntegers.expectLeftOut({output, "VEC4 of componentType 5120", "normalized"});
}

TEST(BadAnimation, ZeroIsNoRotation) {
    AnimatedBox linear("rotation");
    linear.setValues<float>({0, 0, 0, 1, 0, 0, 0, 0}, 4);
    linear.expectLeftOut({output, "(0, 0, 0, 0)", "element 1"});
    AnimatedBox spline("rotation"); // its tangents may be zero, but not its values
    spline.sampler()["interpolation"] = "CUBICSPLINE";
    std::vector<float> values(24, 0.0f);
    values[4 + 3] = 1.0f;
    spline.setValues(values, 4);
    spline.expectLeftOut({output, "(0, 0, 0, 0)", "element 4"});
    values[16 + 3] = 1.0f;
    spline.setValues(values, 4);
    spline.expectSound();
}

TEST(BadAnimation, APropertyIsMovedByOneChannel) {
    AnimatedBox scene;
    Json& channels = scene.gltf.json["animations"][0]["channels"];
    channels.push_back(Json(channels[0]));
    scene.setValues<float>({0, 0, 0, 4, 0, 0}, 3);
    scene.expectPlayed({"animations[0]", "nodes[0].translation", "two channels", "the channel is"},
                       {{0.5, 2.0}});
}

TEST(BadAnimation, OfAMatrixItsPartsAreMoved) {
    AnimatedBox scene;
    scene.gltf.json["nodes"][0]["matrix"] = {0, 0, -2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 7, 8, 9, 1};
    scene.setValues<float>({0, 0, 0, 4, 0, 0}, 3);
    scene.expectPlayed({"nodes[0].matrix", "animations[0]"}, {{0.0, 0.0}, {0.5, 2.0}});
    const NodeTransform rest = scene.read().animation->motions.at(0).rest;
    EXPECT_LT(glm::distance(rest.translation, {7, 8, 9}), 1e-9);
    EXPECT_LT(glm::distance(rest.scale, {2, 3, 4}), 1e-9);
    EXPECT_LT(glm::distance(rest.rotation * glm::dvec3(1, 0, 0), {0, 0, -1}), 1e-9);
}

TEST(BadAnimation, AMatrixWithoutPartsCannotBeMoved) {
    for (const Json& matrix : {Json{1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                               Json{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}) {
        AnimatedBox scene;
        scene.gltf.json["nodes"][0]["matrix"] = matrix;
        scene.expectLeftOut({"nodes[0].matrix", "animations[0]"});
    }
}

TEST(BadAnimation, ABrokenChannelLeavesTheOthers) {
    const std::vector<std::function<void(AnimatedBox&)>> faults = {
        [](AnimatedBox& scene) {
            scene.setTimes<float>({1.0f, 0.5f});
        },
        [](AnimatedBox& scene) { scene.setValues(std::vector<float>(3), 3); },
        [](AnimatedBox& scene) {
            scene.setValues<float>({0, 0, 0, 0, infinity, 0}, 3);
        },
        [](AnimatedBox& scene) { scene.sampler()["interpolation"] = "SMOOTH"; },
        [](AnimatedBox& scene) { scene.sampler()["input"] = 99; },
        [](AnimatedBox& scene) { scene.sampler().erase("output"); },
        [](AnimatedBox& scene) { scene.sampler() = 7; },
        [](AnimatedBox& scene) { scene.channel()["target"]["node"] = 99; },
        [](AnimatedBox& scene) { scene.channel()["target"]["path"] = "shear"; },
        [](AnimatedBox& scene) { scene.channel()["sampler"] = 99; },
        [](AnimatedBox& scene) { scene.channel() = "all"; }};
    for (std::size_t i = 0; i < faults.size(); ++i) {
        AnimatedBox scene;
        scene.addRotation();
        faults[i](scene);
        const auto reading = scene.read();
        ASSERT_TRUE(reading.animation) << "fault " << i;
        EXPECT_TRUE(reading.animation->motions.at(0).rotation) << "fault " << i;
        EXPECT_FALSE(reading.animation->motions.at(0).translation) << "fault " << i;
        ASSERT_EQ(reading.warnings.size(), 1u) << "fault " << i;
        EXPECT_TRUE(reading.warnings[0].ends_with("; the channel is left out."))
            << reading.warnings[0];
    }
}

TEST(BadAnimation, SamplersOfNoChannelAreNotLookedAt) {
    AnimatedBox scene;
    scene.gltf.json["animations"][0]["samplers"].push_back({{"input", "none"}});
    scene.expectSound();
}

TEST(BadAnimation, NodesAndAccessorsMustExist) {
    // Parsing finds these errors, before an animation is read.
    AnimatedBox noNode;
    noNode.gltf.json["animations"][0]["channels"][0]["target"]["node"] = 7;
    noNode.expectLeftOut({"animations[0].channels[0].target.node", "7"});
    AnimatedBox noAccessor;
    noAccessor.sampler()["output"] = 99;
    noAccessor.expectLeftOut({output, "99"});
}

TEST(BadAnimation, TheNextOneIsPlayed) {
    AnimatedBox scene;
    scene.gltf.animate(0, "rotation");
    scene.sampler()["interpolation"] = "SMOOTH";
    const auto afterUnknownWord = scene.read();
    ASSERT_TRUE(afterUnknownWord.animation);
    EXPECT_TRUE(afterUnknownWord.animation->motions.at(0).rotation);
    ASSERT_EQ(afterUnknownWord.warnings.size(), 1u);
    EXPECT_NE(afterUnknownWord.warnings[0].find("SMOOTH"), std::string::npos);

    scene.sampler().erase("interpolation");
    scene.setTimes<float>({1.0f, 0.5f});
    const auto afterUnorderedTimes = scene.read();
    ASSERT_TRUE(afterUnorderedTimes.animation);
    EXPECT_TRUE(afterUnorderedTimes.animation->motions.at(0).rotation);
    EXPECT_FALSE(afterUnorderedTimes.animation->motions.at(0).translation);
    ASSERT_EQ(afterUnorderedTimes.warnings.size(), 1u);
    EXPECT_NE(afterUnorderedTimes.warnings[0].find("times must increase"), std::string::npos);
}

TEST(BadAnimation, ManySamplersOfOneAccessorAreReadOnce) {
    // A thousand nodes share a hundred thousand keyframes: reading them for each node would take
    // minutes.
    AnimatedBox scene;
    std::vector<float> times(100000);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = static_cast<float>(i);
    scene.setTimes(times);
    scene.setValues(std::vector<float>(3 * times.size()), 3);
    Json& animation = scene.gltf.json["animations"][0];
    for (int i = 1; i < 1000; ++i) {
        const int node = scene.gltf.addNode(Json::object());
        animation["samplers"].push_back(Json(animation["samplers"][0]));
        animation["channels"].push_back(
            {{"sampler", i}, {"target", {{"node", node}, {"path", "translation"}}}});
    }
    Warnings warnings;
    const auto read = readAnimation(parseGltf(scene.gltf.glb(), "test.glb"), warnings);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->motions.size(), 1000u);
    EXPECT_EQ(read->motions.at(1).translation->values, read->motions.at(999).translation->values);
}

} // namespace edgeshade::test
