#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/variants.hpp"

#include "preprocess/mesh/topology.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A box, opaque by itself and as "day", blended as "night"; "dusk" doesn't mention it.
GltfBuilder sceneOfVariants() {
    GltfBuilder gltf;
    gltf.useExtension("KHR_materials_variants");
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}});
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}});
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.json["extensions"]["KHR_materials_variants"]["variants"] = {
        {{"name", "day"}}, {{"name", "night"}}, {{"name", "dusk"}}};
    const Json mappings = {{{"material", 1}, {"variants", {0}}},
                           {{"material", 2}, {"variants", {1}}}};
    gltf.addShapeNode(
        box(glm::vec3(1.0f)),
        {{"material", 0}, {"extensions", {{"KHR_materials_variants", {{"mappings", mappings}}}}}});
    return gltf;
}

Scene sceneIn(const GltfBuilder& gltf, const std::string& variant) {
    return flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0, {variant});
}

std::size_t materialIn(const std::string& variant) {
    return sceneIn(sceneOfVariants(), variant).batches.at(0).geometry->groups.at(0).material;
}

} // namespace

TEST(Variants, AreListed) {
    const GltfDocument document = parseGltf(sceneOfVariants().glb(), "test.glb");
    EXPECT_EQ(variantNames(document), (std::vector<std::string>{"day", "night", "dusk"}));
}

TEST(Variants, ChooseMaterials) {
    EXPECT_EQ(materialIn(""), 0u);
    EXPECT_EQ(materialIn("day"), 1u);
    EXPECT_EQ(materialIn("night"), 2u);
    EXPECT_EQ(materialIn("dusk"), 0u);
}

TEST(Variants, DecideWhatCasts) {
    const Scene night = sceneIn(sceneOfVariants(), "night");
    EXPECT_TRUE(castersOf(night.batches.at(0), night.materials, false).indices.empty());
}

TEST(Variants, AnUnknownOneIsWarnedOf) {
    const Scene scene = sceneIn(sceneOfVariants(), "noon");
    ASSERT_EQ(scene.warnings.sentences().size(), 1u);
    EXPECT_EQ(scene.warnings.sentences()[0],
              "'test.glb' has no variant 'noon'; it has 'day', 'night', 'dusk'.");
    EXPECT_EQ(scene.batches.at(0).geometry->groups.at(0).material, 0u);

    GltfBuilder plain;
    plain.addShapeNode(box(glm::vec3(1.0f)));
    const auto warnings = sceneIn(plain, "noon").warnings.sentences();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "'test.glb' has no variant 'noon'; it has none.");
}

TEST(Variants, BrokenOnesAreWarnedOf) {
    GltfBuilder gltf = sceneOfVariants();
    Json& mapping = gltf.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]
                             ["mappings"][0];
    mapping["material"] = 7;
    const auto warnings = sceneIn(gltf, "day").warnings.sentences();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("meshes[0].primitives[0].extensions.KHR_materials_variants.mappings["
                               "0].material is 7, but there are 3 materials"),
              std::string::npos);
    EXPECT_TRUE(sceneIn(gltf, "").warnings.sentences().empty()); // unused parts aren't read
    gltf.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", 7}}, "night"};
    EXPECT_EQ(variantNames(parseGltf(gltf.glb(), "test.glb")), (std::vector<std::string>{"", ""}));
}

} // namespace edgeshade::test
