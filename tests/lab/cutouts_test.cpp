// MASK surfaces cast the shadow of what their alpha leaves, wherever shadow is looked up: compared
// with the oracle.

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/image/image_choice.hpp"
#include "src/image/png.hpp"
#include "src/lab/compare.hpp"
#include "src/scene/cutout_atlas.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/headless.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using test::GltfBuilder;
using test::Json;

constexpr int repeat = 10497, clampToEdge = 33071, mirrored = 33648, nearest = 9728, linear = 9729;

/// Blobs of alpha.
Bytes leafPng(int width, int height, unsigned seed) {
    std::mt19937 draw(seed);
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < width * height; ++i) {
        const auto alpha = static_cast<std::uint8_t>(draw() % 256);
        rgba.insert(rgba.end(), {40, 120, 30, alpha});
    }
    return encodePng(rgba, width, height);
}

/// A square of leaves, from -half to half in x and y, with texture coordinates from `low` to
/// `high`.
test::Shape leaves(float half, float low, float high) {
    test::Shape shape;
    shape.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    shape.normals.assign(4, {0, 0, 1});
    shape.texcoords = {{low, high}, {high, high}, {high, low}, {low, low}};
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

Json leafMaterial(int texture, double cutoff = 0.5, double factor = 1.0) {
    return {{"alphaMode", "MASK"},
            {"alphaCutoff", cutoff},
            {"pbrMetallicRoughness",
             {{"metallicFactor", 0},
              {"baseColorFactor", {1, 1, 1, factor}},
              {"baseColorTexture", {{"index", texture}}}}}};
}

struct Leaves {
    int wrapS = repeat, wrapT = repeat, filter = linear;
    float low = -0.7f, high = 2.3f;
};

/// A box on a floor beneath slanted leaves of two textures.
LoadedScene grove(const Leaves& of) {
    GltfBuilder gltf;
    gltf.json["samplers"] = {{{"wrapS", of.wrapS},
                              {"wrapT", of.wrapT},
                              {"magFilter", of.filter},
                              {"minFilter", of.filter}}};
    for (const auto& [width, height] : {std::pair(8, 16), {5, 4}}) {
        const int image =
            gltf.addImage({{"uri", test::dataUri(leafPng(width, height, 7), "image/png")}});
        gltf.json["textures"].push_back({{"source", image}, {"sampler", 0}});
    }
    gltf.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
    gltf.addMaterial(leafMaterial(0));
    gltf.addMaterial(leafMaterial(1, 0.3, 0.8));
    gltf.addShapeNode(test::box({4, 0.1f, 4}), {{"material", 0}});
    gltf.addNode({{"mesh", gltf.addShape(test::box({0.4f, 0.5f, 0.4f}), {{"material", 0}})},
                  {"translation", {0.8, 0.6, 0.3}}});
    const int oak = gltf.addShape(leaves(1.2f, of.low, of.high), {{"material", 1}});
    const int fern = gltf.addShape(leaves(0.8f, of.low, of.high), {{"material", 2}});
    gltf.addNode({{"mesh", oak}, {"translation", {0, 2, 0}}, {"rotation", {0.6, 0, 0, 0.8}}});
    gltf.addNode(
        {{"mesh", oak}, {"translation", {-0.5, 1.3, -0.6}}, {"rotation", {-0.48, 0.36, 0, 0.8}}});
    gltf.addNode({{"mesh", fern}, {"translation", {1.2, 0.9, 1.1}}});
    LoadedScene loaded;
    loaded.document = std::make_shared<const GltfDocument>(parseGltf(gltf.glb(), "test.glb"));
    loaded.scene = flattenScene(*loaded.document, 0.0);
    loaded.images = decodeImages(*loaded.document, loaded.scene);
    loaded.planePairs = buildPlanePairs(loaded.scene, false);
    loaded.cutoutsCast = true;
    return loaded;
}

lab::CompareResult compared(const LoadedScene& loaded, const Light& light,
                            ShadowMethod method = ShadowMethod::primitiveMap) {
    lab::CompareTask task;
    task.width = 240;
    task.height = 180;
    const Camera camera{{2, 4, 6}, {0, 0.8, 0}, 45.0};
    task.views = {{"", frustumOf(camera, 240.0 / 180.0), light}};
    lab::Contender contender;
    contender.settings.shadows = method;
    contender.settings.shading = Shading::full;
    task.contenders = {contender};
    return lab::compareAll(loaded, task, [](double, const std::string&) {}).front();
}

const std::vector<Light>& someLights() {
    static const std::vector<Light> lights = {
        test::sun({0.3, 1, 0.4}), test::sun({-1, 0.5, 0.2}), test::pointLight({1, 5, 2}),
        test::pointLight({0.1, 1.6, 0.2})}; // among the leaves: six tiles
    return lights;
}

void expectExact(const lab::CompareResult& result) {
    EXPECT_EQ(result.counts.beyond1pxNotTied, 0u);
    // On the leaves themselves the device's filter decides where a hole ends.
    EXPECT_LE(result.counts.wrongMaskBeyond1px, result.counts.visiblePixels / 200);
    EXPECT_EQ(result.lights.front().method, "primitive-map");
}

TEST(Cutouts, AreExactWhereTheyAreLookedUp) {
    for (const Leaves& of :
         {Leaves{}, Leaves{mirrored, clampToEdge}, Leaves{clampToEdge, mirrored, nearest},
          Leaves{repeat, repeat, nearest, 0.0f, 1.0f}})
        for (const Light& light : someLights()) {
            SCOPED_TRACE(std::to_string(of.wrapS) + " " + std::to_string(of.filter) + ", light " +
                         std::to_string(light.position.x));
            expectExact(compared(grove(of), light));
        }
}

TEST(Cutouts, AreNothingThatVolumesCount) {
    const lab::CompareResult result =
        compared(grove({}), someLights().front(), ShadowMethod::volumes);
    EXPECT_GT(result.counts.beyond1pxNotTied, 30u) << "the oracle sees them";
}

TEST(Cutouts, AreInShadowMapsToo) {
    const Light& light = someLights().front();
    const auto mapped = compared(grove({}), light, ShadowMethod::map);
    const auto counted = compared(grove({}), light, ShadowMethod::volumes);
    EXPECT_LT(3 * mapped.counts.wrongImageBeyond1px, counted.counts.wrongImageBeyond1px);
}

TEST(Cutouts, CastNothingUnlessAsked) {
    LoadedScene loaded = grove({});
    loaded.cutoutsCast = false;
    for (const Light& light : someLights())
        expectExact(compared(loaded, light));
}

TEST(Cutouts, OfAtlasesLieApart) {
    const LoadedScene loaded = grove({mirrored, clampToEdge});
    const CutoutAtlas atlas = cutoutAtlasOf(loaded, 4096);
    ASSERT_EQ(atlas.textures.size(), loaded.scene.materials.size());
    const CutoutTexture &one = atlas.textures[1], &other = atlas.textures[2];
    EXPECT_EQ(atlas.textures[0].size, glm::ivec2(0));
    EXPECT_EQ(one.size, glm::ivec2(8, 16));
    EXPECT_EQ(other.size, glm::ivec2(5, 4));
    EXPECT_EQ(one.wrapS, CutoutWrap::mirror);
    EXPECT_EQ(one.wrapT, CutoutWrap::clamp);
    EXPECT_FLOAT_EQ(other.cutoff, 0.3f);
    const bool apart = one.place.x + 8 <= other.place.x || other.place.x + 5 <= one.place.x ||
                       one.place.y + 16 <= other.place.y || other.place.y + 4 <= one.place.y;
    EXPECT_TRUE(apart);
    const auto image = pixelsOf(loaded, 1);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            EXPECT_EQ(atlas.alpha[static_cast<std::size_t>((other.place.y + y) * atlas.width +
                                                           other.place.x + x)],
                      image->rgba[static_cast<std::size_t>(4 * (5 * y + x) + 3)]);
}

TEST(Cutouts, OfLargeTexturesAreTakenSmaller) {
    const CutoutAtlas atlas = cutoutAtlasOf(grove({}), 12);
    EXPECT_LE(std::max(atlas.width, atlas.height), 12);
    EXPECT_EQ(atlas.textures[1].size, glm::ivec2(4, 8));
    EXPECT_EQ(atlas.textures[2].size, glm::ivec2(2, 2));
}

} // namespace
} // namespace edgeshade
