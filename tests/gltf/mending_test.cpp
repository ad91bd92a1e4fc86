// Output of exporters that glTF forbids, but that has only one meaning.
#include "preprocess/gltf/utf8.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A box, textured and animated, below a node, with an unused skin.
GltfBuilder sceneOfWholeNumbers() {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["samplers"] = {{{"wrapS", 10497}, {"minFilter", 9729}}};
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    gltf.addMaterial({{"pbrMetallicRoughness",
                       {{"baseColorFactor", {1.0, 0.5, 1.0, 1.0}},
                        {"baseColorTexture", {{"index", 0}, {"texCoord", 0}}}}}});
    const int box = gltf.addNode(
        {{"mesh", gltf.addShape(test::box(glm::vec3(1.0f)), {{"material", 0}, {"mode", 4}})},
         {"translation", {1.0, 0.0, 0.0}}},
        false);
    gltf.addNode({{"children", {box}}});
    gltf.json["skins"] = {{{"joints", {box}}}};
    gltf.animate(box);
    return gltf;
}

/// Writes every whole number in the form 96.0, except in `skipped`.
void makeReal(Json& json, const std::string& skipped) {
    if (json.is_number_integer())
        json = json.get<double>();
    else if (json.is_structured())
        for (auto& [key, value] : json.items())
            if (key != skipped) makeReal(value, skipped);
}

std::vector<std::string> warningsOf(const GltfBuilder& gltf) {
    return sceneOf(gltf).warnings.sentences();
}

} // namespace

TEST(Mending, AStrideOfZeroIsNone) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    const auto expected = worldTriangles(sceneOf(gltf));
    for (Json& view : gltf.json["bufferViews"])
        view["byteStride"] = 0;
    expectSameTriangles(worldTriangles(sceneOf(gltf)), expected);
    EXPECT_TRUE(warningsOf(gltf).empty());
    const GlbParts written(packed(gltf.glb(), Encoding::none));
    for (const Json& view : written.json.at("bufferViews"))
        EXPECT_FALSE(view.contains("byteStride"));
}

TEST(Mending, WholeNumbersMayBeWrittenAsReals) {
    GltfBuilder gltf = sceneOfWholeNumbers();
    const auto expected = worldTriangles(sceneOf(gltf));
    const Bytes expectedPack = packed(gltf.glb(), Encoding::indexed);
    GlbParts real(gltf.glb());
    makeReal(real.json, "asset");
    ASSERT_NE(real.json.dump().find("\"componentType\":5126.0"), std::string::npos);
    expectSameTriangles(worldTriangles(sceneOf(real.glb())), expected);
    EXPECT_TRUE(sceneOf(real.glb()).warnings.sentences().empty());
    EXPECT_EQ(packed(real.glb(), Encoding::indexed), expectedPack);
}

TEST(Mending, WholeNumbersMayHaveExponents) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    std::string text = gltf.gltf();
    const std::string count = "\"count\": 24";
    for (std::size_t at; (at = text.find(count)) != std::string::npos;)
        text.replace(at, count.size(), "\"count\":2.4e1");
    EXPECT_EQ(sceneOf(Bytes(text.begin(), text.end())).triangleCount(), 12u);
}

TEST(Mending, PackedScenesMayBeRewrittenWithReals) {
    GlbParts parts(packed(variedScene().glb(), Encoding::indexed));
    makeReal(parts.json, "asset");
    expectSameShadows(readBack(parts.glb()), built(variedScene().glb()));
}

TEST(Mending, WhatIsNotWholeIsRefused) {
    GltfBuilder gltf = sceneOfWholeNumbers();
    gltf.json["nodes"][1]["children"] = {0.5};
    expectInputError([&] { sceneOf(gltf); }, {"nodes[1].children[0] is 0.5", "whole number"});
    gltf.json["nodes"][1]["children"] = {1e30};
    expectInputError([&] { sceneOf(gltf); }, {"nodes[1].children[0] is 1e+30", "whole number"});
}

TEST(Mending, ExtrasAndFactorsStayAsTheyAre) {
    GltfBuilder gltf = sceneOfWholeNumbers();
    gltf.json["nodes"][0]["extras"] = {{"count", 1.0}};
    gltf.json["extras"] = {{"count", 1.0}};
    const Json json = GlbParts(packed(gltf.glb(), Encoding::none)).json;
    EXPECT_TRUE(json["nodes"][0]["extras"]["count"].is_number_float());
    EXPECT_TRUE(json["extras"]["count"].is_number_float());
    EXPECT_EQ(json["materials"], gltf.json["materials"]);
    EXPECT_TRUE(json["nodes"][0]["translation"][0].is_number_float());
}

TEST(Mending, NamesThatAreNoTextAreLeftOut) {
    GltfBuilder gltf = sceneOfWholeNumbers();
    gltf.json["nodes"][0]["name"] = 7;
    gltf.json["meshes"][0]["name"] = "box";
    const auto warnings = warningsOf(gltf);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0],
              "'test.glb': nodes[0].name is 7, but must be text; the name is left out.");
    const Json json = GlbParts(packed(gltf.glb(), Encoding::none)).json;
    EXPECT_FALSE(json["nodes"][0].contains("name"));
    EXPECT_EQ(json["meshes"][0]["name"], "box");
}

TEST(Mending, TextThatIsNoUtf8IsReplaced) {
    GltfBuilder gltf = sceneOfWholeNumbers();
    gltf.json["nodes"][0]["name"] = "caf?";
    gltf.json["nodes"][0]["extras"] = {{"author", "Zo?"}};
    std::string text = gltf.gltf();
    text[text.find("caf?") + 3] = '\xE9';
    text[text.find("Zo?") + 2] = '\xEB';
    const Bytes bytes(text.begin(), text.end());
    const auto warnings = sceneOf(bytes).warnings.sentences();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("not UTF-8"), std::string::npos);
    EXPECT_NE(warnings[0].find("byte " + std::to_string(text.find("caf\xE9") + 3)),
              std::string::npos);
    const Json json = GlbParts(packed(bytes, Encoding::none)).json;
    EXPECT_EQ(json["nodes"][0]["name"], "caf\uFFFD");
    EXPECT_EQ(json["nodes"][0]["extras"]["author"], "Zo\uFFFD");
}

TEST(Utf8, EveryLengthOfCharacterIsValid) {
    const std::string text = "a\u00E9\u20AC\U0001F600\U0010FFFF\uD7FF\uE000";
    EXPECT_FALSE(firstInvalidUtf8(text));
    EXPECT_EQ(withValidUtf8(text), text);
}

TEST(Utf8, OverlongCharactersSurrogatesAndOpenEndsAreNot) {
    for (const std::string bad :
         {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xED\xA0\x80",
          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82", "\xC3"}) {
        EXPECT_EQ(firstInvalidUtf8("ab" + bad), 2u);
        const std::string mended = withValidUtf8(bad + "z");
        EXPECT_FALSE(firstInvalidUtf8(mended));
        EXPECT_TRUE(mended.starts_with("\uFFFD") && mended.ends_with("z"));
    }
}

} // namespace edgeshade::test
