// Keyframes that are none: each is refused by one sentence that names the field and the value.
// Indices and words are refused earlier: tests/cli/bad_animations.cpp.
#include "preprocess/animation_reading.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace edgeshade::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
const char* const input = "animations[0].samplers[0].input";
const char* const output = "animations[0].samplers[0].output";

/// A box that an animation moves, with samplers[0] to be tampered with.
struct AnimatedBox {
    GltfBuilder gltf;

    explicit AnimatedBox(const std::string& path = "translation") {
        gltf.animate(gltf.addShapeNode(box(glm::vec3(1.0f))), path);
    }
    Json& sampler() { return gltf.json["animations"][0]["samplers"][0]; }
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
    void read() const {
        Warnings warnings;
        readAnimation(parseGltf(gltf.glb(), "test.glb"), warnings);
    }
    void expectRefused(std::initializer_list<const char*> words) const {
        expectInputError([&] { read(); }, {"'test.glb'"});
        expectInputError([&] { read(); }, words);
    }
};

void expectTimesRefused(const std::vector<float>& times, std::initializer_list<const char*> words) {
    AnimatedBox scene;
    scene.setTimes(times);
    scene.expectRefused({input});
    scene.expectRefused(words);
}

} // namespace

TEST(BadAnimation, TheSceneOfTheseTestsIsSound) {
    EXPECT_NO_THROW(AnimatedBox("translation").read());
    EXPECT_NO_THROW(AnimatedBox("rotation").read());
    EXPECT_NO_THROW(AnimatedBox("scale").read());
}

TEST(BadAnimation, TimesMustIncrease) {
    expectTimesRefused({0.5f, 0.5f}, {"holds 0.5 at element 1 after 0.5"});
    expectTimesRefused({0.0f, 2.0f, 1.5f}, {"holds 1.5 at element 2 after 2"});
}

TEST(BadAnimation, TimesMustNotBeNegative) {
    expectTimesRefused({-0.25f, 1.0f}, {"-0.25"});
}

TEST(BadAnimation, TimesMustBeFinite) {
    expectTimesRefused({0.0f, infinity}, {"infinite", "element 1"});
    expectTimesRefused({notANumber, 1.0f}, {"NaN", "element 0"});
}

TEST(BadAnimation, TimesMustBeThere) {
    AnimatedBox scene;
    scene.accessor("input")["count"] = 0;
    scene.expectRefused({input, "no elements"});
}

TEST(BadAnimation, TimesMustBeScalarFloats) {
    AnimatedBox integers;
    integers.setTimes<std::uint16_t>({0, 1});
    integers.expectRefused({input, "5123", "must be SCALAR floats"});
    AnimatedBox vectors;
    vectors.sampler()["input"] = vectors.gltf.addArray<float>({0, 0, 1, 1}, 2);
    vectors.expectRefused({input, "VEC2", "must be SCALAR floats"});
}

TEST(BadAnimation, TimesMustLieWithinTheirView) {
    AnimatedBox scene;
    scene.accessor("input")["count"] = 1000;
    scene.expectRefused({input, "1000"});
}

TEST(BadAnimation, ClaimedTimesWithoutDataAreRefused) {
    AnimatedBox scene;
    scene.accessor("input").erase("bufferView");
    scene.accessor("input")["count"] = 1000000000;
    scene.expectRefused({input, "1000000000"});
}

TEST(BadAnimation, ClaimedValuesWithoutDataAreRefused) {
    AnimatedBox scene;
    scene.accessor("output").erase("bufferView");
    scene.accessor("output")["count"] = 1000000000;
    scene.expectRefused({output, "1000000000"});
}

TEST(BadAnimation, AValueATime) {
    AnimatedBox few;
    few.setValues(std::vector<float>(3), 3);
    few.expectRefused({output, "has 1 elements", "LINEAR of 2 times needs 2"});
    AnimatedBox many;
    many.setValues(std::vector<float>(9), 3);
    many.expectRefused({output, "has 3 elements", "needs 2"});
}

TEST(BadAnimation, ThreeValuesATimeOfASpline) {
    AnimatedBox scene;
    scene.sampler()["interpolation"] = "CUBICSPLINE";
    scene.expectRefused({output, "has 2 elements", "CUBICSPLINE of 2 times needs 6"});
}

TEST(BadAnimation, ASplineNeedsTwoTimes) {
    AnimatedBox scene;
    scene.sampler()["interpolation"] = "CUBICSPLINE";
    scene.setTimes<float>({0.0f});
    scene.setValues(std::vector<float>(9), 3);
    scene.expectRefused({input, "1 element", "CUBICSPLINE"});
}

TEST(BadAnimation, ValuesMustBeFinite) {
    AnimatedBox scene;
    scene.setValues<float>({0, 0, 0, 0, infinity, 0}, 3);
    scene.expectRefused({output, "infinite", "element 1"});
    AnimatedBox turning("rotation");
    turning.setValues<float>({notANumber, 0, 0, 1, 0, 0, 0, 1}, 4);
    turning.expectRefused({output, "NaN", "element 0"});
}

TEST(BadAnimation, TranslationsAndScalesMustBeVectorsOfFloats) {
    for (const char* path : {"translation", "scale"}) {
        AnimatedBox wide(path);
        wide.setValues(std::vector<float>(8), 4);
        wide.expectRefused({output, "VEC4", "must be VEC3 floats"});
        AnimatedBox small(path);
        small.setValues(std::vector<std::int16_t>(6), 3, {{"normalized", true}});
        small.expectRefused({output, "normalized componentType 5122", "must be VEC3 floats"});
    }
}

TEST(BadAnimation, RotationsMustBeQuaternions) {
    AnimatedBox narrow("rotation");
    narrow.setValues(std::vector<float>(6), 3);
    narrow.expectRefused({output, "VEC3", "must be VEC4"});
    AnimatedBox wide("rotation");
    wide.setValues(std::vector<std::uint32_t>(8, 1), 4, {{"normalized", true}});
    wide.expectRefused({output, "5125"});
    AnimatedBox plainIntegers("rotation");
    plainIntegers.setValues(std::vector<std::int8_t>(8, 1), 4);
    plainIntegers.expectRefused({output, "VEC4 of componentType 5120", "normalized"});
}

TEST(BadAnimation, ZeroIsNoRotation) {
    AnimatedBox linear("rotation");
    linear.setValues<float>({0, 0, 0, 1, 0, 0, 0, 0}, 4);
    linear.expectRefused({output, "(0, 0, 0, 0)", "element 1"});
    AnimatedBox spline("rotation"); // its tangents may be zero, its values not
    spline.sampler()["interpolation"] = "CUBICSPLINE";
    std::vector<float> values(24, 0.0f);
    values[4 + 3] = 1.0f;
    spline.setValues(values, 4);
    spline.expectRefused({output, "(0, 0, 0, 0)", "element 4"});
    values[16 + 3] = 1.0f;
    spline.setValues(values, 4);
    EXPECT_NO_THROW(spline.read());
}

TEST(BadAnimation, APropertyIsMovedByOneChannel) {
    AnimatedBox scene;
    Json& channels = scene.gltf.json["animations"][0]["channels"];
    channels.push_back(Json(channels[0]));
    scene.expectRefused({"animations[0]", "nodes[0].translation", "two channels"});
}

TEST(BadAnimation, AMatrixCannotBeMoved) {
    AnimatedBox scene;
    scene.gltf.json["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
    scene.expectRefused({"nodes[0].matrix", "animations[0]"});
}

TEST(BadAnimation, NodesAndAccessorsMustExist) {
    // Parsing refuses them, before an animation is read.
    AnimatedBox noNode;
    noNode.gltf.json["animations"][0]["channels"][0]["target"]["node"] = 7;
    noNode.expectRefused({"animations[0].channels[0].target.node", "7"});
    AnimatedBox noAccessor;
    noAccessor.sampler()["output"] = 99;
    noAccessor.expectRefused({output, "99"});
}

TEST(BadAnimation, ManySamplersOfOneAccessorAreReadOnce) {
    // A thousand nodes that share a hundred thousand keyframes: minutes if each read its own.
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
