#include "tests/support/packing.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/mesh/caster_simplification.hpp"
#include "preprocess/packing/packed_file.hpp"
#include "preprocess/reading/flatten.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

bool sameBits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0);
}

} // namespace

Packed packedWithWarnings(const Bytes& asset, Encoding encoding, const CasterSettings& settings,
                          const std::filesystem::path& path) {
    const GltfDocument document = parseGltf(asset, path);
    Scene scene = flattenScene(document, settings.weldTolerance, {}, settings.instances);
    simplifyCasters(scene, settings.casterError);
    BuildSeconds seconds;
    Warnings warnings;
    Bytes glb = packedGlb(document, scene, buildTopology(scene, settings.castMasked, seconds),
                          encoding, settings, warnings);
    return {std::move(glb), warnings.sentences()};
}

Bytes packed(const Bytes& asset, Encoding encoding, const CasterSettings& settings,
             const std::filesystem::path& path) {
    return packedWithWarnings(asset, encoding, settings, path).glb;
}

Shadows readBack(const Bytes& packedAsset) {
    const GltfDocument document = parseGltf(packedAsset, "packed.glb");
    const auto header = readShadowHeader(document);
    if (!header) throw InputError("'packed.glb' is not packed.");
    Scene scene =
        flattenScene(document, header->settings.weldTolerance, {}, header->settings.instances);
    readCasters(document, *header, scene);
    return readShadows(document, *header, scene);
}

Shadows built(const Bytes& asset, const CasterSettings& settings) {
    Scene scene =
        flattenScene(parseGltf(asset, "test.glb"), settings.weldTolerance, {}, settings.instances);
    simplifyCasters(scene, settings.casterError);
    return buildShadows(scene, settings.castMasked);
}

void expectSameShadows(const Shadows& actual, const Shadows& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
        EXPECT_EQ(actual[i]->sides.maxMultiplicity, expected[i]->sides.maxMultiplicity);
        EXPECT_TRUE(sameBits(actual[i]->sides.records, expected[i]->sides.records))
            << "batch " << i;
        EXPECT_TRUE(sameBits(actual[i]->caps.records, expected[i]->caps.records)) << "batch " << i;
        ASSERT_EQ(actual[i]->groups.size(), expected[i]->groups.size());
        for (std::size_t g = 0; g < actual[i]->groups.size(); ++g) {
            EXPECT_EQ(actual[i]->groups[g].material, expected[i]->groups[g].material);
            EXPECT_EQ(actual[i]->groups[g].firstCap, expected[i]->groups[g].firstCap);
            EXPECT_EQ(actual[i]->groups[g].capCount, expected[i]->groups[g].capCount);
        }
    }
}

GltfBuilder variedScene() {
    GltfBuilder gltf;
    gltf.addMaterial({{"name", "opaque"}, {"extras", {{"kept", true}}}});
    gltf.addMaterial({{"alphaMode", "MASK"}});
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.addShapeNode(box(glm::vec3(1.0f, 2.0f, 3.0f)), {{"material", 0}});
    gltf.addShapeNode(book(7));
    Shape withDegenerate = tetrahedron();
    withDegenerate.indices.insert(withDegenerate.indices.begin() + 3, {1, 1, 2});
    gltf.addShapeNode(withDegenerate, {{"material", 1}});
    gltf.addShapeNode(box(glm::vec3(0.3f)), {{"material", 2}});
    const int animatedNode = gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(0.5f)))},
                                           {"translation", {1e5, 3, 0.25}},
                                           {"scale", {1, -1, 1}}});
    gltf.animate(animatedNode);
    const int castsNothing =
        gltf.addNode({{"mesh", gltf.addShape(tetrahedron(), {{"material", 2}})}});
    gltf.animate(castsNothing);
    return gltf;
}

} // namespace edgeshade::test
