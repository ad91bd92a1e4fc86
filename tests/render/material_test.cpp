// Full shading: drawn materials against the specification's formulas in double.

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/image/image_choice.hpp"
#include "src/image/png.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/reference_shading.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::displayedBytes;
using test::GltfBuilder;
using test::Json;
using test::ReferenceSurface;
using test::reflectedLight;
using test::sun;

constexpr int size = 32;
const Camera ahead{{0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, 45.0};
const glm::dvec3 aside(1.0, 0.5, 1.5); // towards the light

RenderSettings fullSettings(float ambient = 0.0f) {
    RenderSettings settings;
    settings.shading = Shading::full;
    settings.ambient = ambient;
    return settings;
}

/// Draws a file's scene with its textures.
std::vector<std::uint8_t> draw(const GltfBuilder& gltf, const test::TestView& view,
                               RenderSettings settings) {
    const gl::HeadlessContext context(test::testPicture(view.width, view.height));
    if (!context.capabilities().instancing) settings.layout = SidesLayout::notInstanced;
    LoadedScene loaded;
    loaded.document = std::make_shared<const GltfDocument>(parseGltf(gltf.glb(), "test.glb"));
    loaded.scene = flattenScene(*loaded.document, 0.0);
    EXPECT_TRUE(loaded.scene.warnings.sentences().empty())
        << loaded.scene.warnings.sentences().front();
    loaded.images = decodeImages(*loaded.document, loaded.scene);
    loaded.planePairs = buildPlanePairs(loaded.scene, false);
    FrameView frame = test::boundedFrame(loaded.scene, false,
                                         {view.seen(), view.width, view.height, view.lights, {}});
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    prepareScene(gpu, loaded, frame, renderer);
    renderer.draw(gpu, frame);
    gl::requireNoError("drawing a material");
    return context.readPixels();
}

/// A wall with the material that faces the eye, u to the right and v down.
struct Wall {
    GltfBuilder gltf;
    test::Shape shape;
    Json attributes = Json::object();

    explicit Wall(float mirror = 1.0f) {
        shape.positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
        shape.normals.assign(4, {0, 0, 1});
        shape.texcoords = {{0, 1}, {mirror, 1}, {mirror, 0}, {0, 0}};
        shape.indices = {0, 1, 2, 0, 2, 3};
    }

    /// A texture of one colour, or of one for each quarter: top left, top right, bottom left,
    /// bottom right.
    int texture(const std::vector<glm::u8vec4>& texels) {
        std::vector<std::uint8_t> rgba;
        for (const glm::u8vec4& texel : texels)
            rgba.insert(rgba.end(), {texel.r, texel.g, texel.b, texel.a});
        const int side = texels.size() == 1 ? 1 : 2;
        const int image =
            gltf.addImage({{"uri", test::dataUri(encodePng(rgba, side, side), "image/png")}});
        gltf.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}}};
        gltf.json["textures"].push_back({{"source", image}, {"sampler", 0}});
        return static_cast<int>(gltf.json["textures"].size()) - 1;
    }

    void finish(const Json& material) {
        gltf.addMaterial(material);
        Json primitive = gltf.primitiveOf(shape, {{"material", 0}});
        primitive["attributes"].update(attributes);
        gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    }
};

using Color = glm::dvec3;

Color at(const std::vector<std::uint8_t>& pixels, int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x));
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

/// The middle of the wall's picture.
Color middle(Wall wall, const Json& material, const RenderSettings& settings = fullSettings(),
             const std::vector<Light>& lights = {sun(aside)}) {
    wall.finish(material);
    return at(draw(wall.gltf, {ahead, lights, size, size}, settings), size / 2, size / 2);
}

void expectNear(const Color& drawn, const Color& expected, double tolerance = 1.5) {
    for (glm::length_t c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn[c], expected[c], tolerance) << "channel " << c;
}

Json metallicRoughness(double metallic, double roughness, const Json& more = Json::object()) {
    Json json = {{"baseColorFactor", {0.8, 0.4, 0.1, 1}},
                 {"metallicFactor", metallic},
                 {"roughnessFactor", roughness}};
    json.update(more);
    return {{"pbrMetallicRoughness", json}};
}

// Seen from the middle pixel, whose centre is half a pixel beside the picture's.
const double half = 3.0 * std::tan(glm::radians(22.5)) / size;
const Color eye(-half, half, 3.0);
const Color copper(0.8, 0.4, 0.1);

TEST(FullShading, MetalAndRoughness) {
    for (const double metallic : {0.0, 0.5, 1.0})
        for (const double roughness : {0.15, 0.4, 0.7, 0.9}) {
            SCOPED_TRACE(std::to_string(metallic) + " " + std::to_string(roughness));
            for (const glm::dvec3& light : {aside, glm::dvec3(0.1, 0.05, 1), glm::dvec3(3, 0, 1)})
                expectNear(
                    middle(Wall(), metallicRoughness(metallic, roughness), fullSettings(),
                           {sun(light)}),
                    displayedBytes(reflectedLight({copper, metallic, roughness}, light, eye)));
        }
}

TEST(FullShading, MetalAndRoughnessByTexture) {
    Wall wall;
    const int texture = wall.texture({{255, 128, 51, 255}}); // roughness in G, metal in B
    const Json material =
        metallicRoughness(1.0, 1.0, {{"metallicRoughnessTexture", {{"index", texture}}}});
    expectNear(middle(wall, material),
               displayedBytes(reflectedLight({copper, 51.0 / 255.0, 128.0 / 255.0}, aside, eye)));
}

TEST(FullShading, PlainSurfacesTakeTheShortWay) {
    // The base colour itself in full light; else scaled by the display's power of the share.
    const Color drawn = middle(Wall(), metallicRoughness(0.0, 1.0));
    const double share = glm::normalize(aside).z;
    for (glm::length_t c = 0; c < 3; ++c) {
        const double base = 1.055 * std::pow(copper[c], 1.0 / 2.4) - 0.055;
        EXPECT_NEAR(drawn[c], 255.0 * base * std::pow(share, 1.0 / 2.2), 1.5);
    }
}

TEST(FullShading, AmbientLightIsTheSameTheShortWay) {
    for (const glm::vec3& normal : {glm::vec3(0, 0, 1), glm::vec3(0, 1, 1), glm::vec3(0, -1, 1)}) {
        const auto drawn = [&](double roughness) {
            Wall wall;
            wall.shape.normals.assign(4, glm::normalize(normal));
            return middle(wall, metallicRoughness(0.0, roughness), fullSettings(0.6f),
                          {sun({0, 0, -1})});
        };
        EXPECT_NEAR(drawn(1.0).r, drawn(0.94).r, 16.0) << normal.y;
    }
}

TEST(FullShading, SurfacesGiveOffLight) {
    Json material = metallicRoughness(0.0, 0.5);
    material["emissiveFactor"] = {0.5, 0.25, 0.0};
    const auto dark = {sun({0, 0, -1})};
    expectNear(middle(Wall(), material, fullSettings(), dark), displayedBytes({0.5, 0.25, 0.0}));
    material["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8.0}}}};
    expectNear(middle(Wall(), material, fullSettings(), dark), displayedBytes({4.0, 2.0, 0.0}));
    Wall wall;
    material["emissiveTexture"] = {{"index", wall.texture({{255, 128, 255, 255}})}};
    expectNear(middle(wall, material, fullSettings(), dark),
               displayedBytes({4.0, 2.0 * test::linearOf(128.0 / 255.0), 0.0}));
}

TEST(FullShading, ExposureScalesLight) {
    Json material = metallicRoughness(0.0, 0.5);
    material["emissiveFactor"] = {0.1, 0.1, 0.1};
    RenderSettings settings = fullSettings();
    settings.exposure = 2.0f;
    expectNear(middle(Wall(), material, settings, {sun({0, 0, -1})}), displayedBytes(Color(0.4)));
}

/// A texture's normal, tilted to the right and up.
const glm::u8vec4 turnedTexel(190, 170, 230, 255);
glm::dvec3 turnedNormal(double mirror, double scale = 1.0) {
    const glm::dvec3 texel = glm::dvec3(190, 170, 230) / 127.5 - 1.0;
    return glm::normalize(glm::dvec3(mirror * scale * texel.x, scale * texel.y, texel.z));
}

TEST(FullShading, NormalsByTextureOfBothHands) {
    if (!test::hasDerivatives()) GTEST_SKIP() << "needs derivatives in shaders";
    for (const float mirror : {1.0f, -1.0f})
        for (const double scale : {1.0, 0.5}) {
            SCOPED_TRACE(mirror);
            Wall wall(mirror);
            Json material = metallicRoughness(0.3, 0.4);
            material["normalTexture"] = {{"index", wall.texture({turnedTexel})}, {"scale", scale}};
            ReferenceSurface surface{copper, 0.3, 0.4};
            surface.normal = turnedNormal(mirror, scale);
            expectNear(middle(wall, material), displayedBytes(reflectedLight(surface, aside, eye)),
                       2.0);
        }
}

TEST(FullShading, NormalsByTextureTakeTheVerticesTangents) {
    for (const float hand : {1.0f, -1.0f}) {
        Wall wall;
        wall.attributes["TANGENT"] = wall.gltf.addArray<float>(
            {0, 1, 0, hand, 0, 1, 0, hand, 0, 1, 0, hand, 0, 1, 0, hand}, 4);
        Json material = metallicRoughness(0.3, 0.4);
        material["normalTexture"] = {{"index", wall.texture({turnedTexel})}};
        const glm::dvec3 texel = turnedNormal(1.0);
        ReferenceSurface surface{copper, 0.3, 0.4};
        surface.normal = {-hand * texel.y, texel.x, texel.z}; // tangent up, bitangent left
        expectNear(middle(wall, material), displayedBytes(reflectedLight(surface, aside, eye)),
                   2.0);
    }
}

TEST(FullShading, OcclusionTakesFromLightFromEverywhereAlone) {
    const auto drawn = [](int value, double strength, float ambient) {
        Wall wall;
        Json material = metallicRoughness(0.0, 0.5);
        const auto red = static_cast<std::uint8_t>(value);
        material["occlusionTexture"] = {{"index", wall.texture({{red, 9, 9, 255}})},
                                        {"strength", strength}};
        return middle(wall, material, fullSettings(ambient));
    };
    expectNear(drawn(0, 1.0, 1.0f), Color(0.0));
    EXPECT_EQ(drawn(0, 0.0, 1.0f), drawn(255, 1.0, 1.0f));
    EXPECT_EQ(drawn(0, 1.0, 0.0f), drawn(255, 1.0, 0.0f));
    EXPECT_LT(drawn(128, 1.0, 1.0f).r, drawn(255, 1.0, 1.0f).r - 20.0);
}

TEST(FullShading, SpecularGlossiness) {
    Json glossy = {{"diffuseFactor", {0.2, 0.1, 0.05, 1}},
                   {"specularFactor", {0.6, 0.5, 0.1}},
                   {"glossinessFactor", 0.7}};
    ReferenceSurface surface{Color(0.2, 0.1, 0.05), 0.0, 0.3, Color(0.6, 0.5, 0.1)};
    // All reflected light reduces its diffuse colour, even at normal incidence.
    const auto expected = [&] {
        ReferenceSurface lessened = surface;
        lessened.baseColor *=
            1.0 - std::max({surface.reflectance.x, surface.reflectance.y, surface.reflectance.z});
        return displayedBytes(reflectedLight(lessened, aside, eye));
    };
    const auto material = [&] {
        return Json{{"extensions", {{"KHR_materials_pbrSpecularGlossiness", glossy}}}};
    };
    expectNear(middle(Wall(), material()), expected());
    Wall wall;
    glossy["specularGlossinessTexture"] = {{"index", wall.texture({{188, 255, 255, 128}})}};
    surface.reflectance.x *= test::linearOf(188.0 / 255.0);
    surface.roughness = 1.0 - 0.7 * 128.0 / 255.0;
    expectNear(middle(wall, material()), expected());
}

TEST(FullShading, UnlitColoursAreAsTheyAre) {
    Json material = metallicRoughness(1.0, 0.2);
    material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
    const Color drawn = middle(Wall(), material);
    for (glm::length_t c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn[c], 255.0 * (1.055 * std::pow(copper[c], 1.0 / 2.4) - 0.055), 1.0);
    const Color twice = middle(Wall(), material, fullSettings(), {sun(aside), sun({0, 0, 1})});
    expectNear(twice, drawn, 2.0);
}

TEST(FullShading, ColoursOfVertices) {
    Wall wall;
    wall.attributes["COLOR_0"] =
        wall.gltf.addArray<float>({0.5, 0.25, 1, 0.5, 0.25, 1, 0.5, 0.25, 1, 0.5, 0.25, 1}, 3);
    expectNear(
        middle(wall, metallicRoughness(0.2, 0.5)),
        displayedBytes(reflectedLight({copper * Color(0.5, 0.25, 1.0), 0.2, 0.5}, aside, eye)),
        2.0);
}

TEST(FullShading, EveryTextureTakesItsOwnCoordinates) {
    // Base colour uses the first set, emission the second one, metal and roughness a transform.
    Wall wall;
    wall.attributes["TEXCOORD_1"] = wall.gltf.addVectors(std::vector<glm::vec2>(4, {0.75f, 0.25f}));
    const int base = wall.texture({{255, 255, 255, 255}});
    const int glow =
        wall.texture({{255, 0, 0, 255}, {0, 128, 0, 255}, {0, 0, 255, 255}, {9, 9, 9, 255}});
    const int rough =
        wall.texture({{0, 255, 0, 255}, {0, 255, 0, 255}, {0, 102, 0, 255}, {0, 255, 0, 255}});
    Json material = metallicRoughness(1.0, 1.0, {{"baseColorTexture", {{"index", base}}}});
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {
        {"index", rough},
        {"extensions", {{"KHR_texture_transform", {{"scale", {0, 0}}, {"offset", {0.25, 0.75}}}}}}};
    material["emissiveFactor"] = {0.5, 0.5, 0.5};
    material["emissiveTexture"] = {{"index", glow}, {"texCoord", 1}};
    const Color glowing(0.0, 0.5 * test::linearOf(128.0 / 255.0), 0.0);
    expectNear(middle(wall, material),
               displayedBytes(reflectedLight({copper, 0.0, 0.4}, aside, eye) + glowing));
}

TEST(FullShading, SpecularAndIndexOfRefraction) {
    Json material = metallicRoughness(0.0, 0.3);
    material["extensions"] = {{"KHR_materials_ior", {{"ior", 2.0}}},
                              {"KHR_materials_specular",
                               {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}}}};
    const double once = std::pow(1.0 / 3.0, 2.0);
    ReferenceSurface surface{copper, 0.0, 0.3, once * 0.5 * Color(1.0, 0.5, 0.0)};
    const Color drawn = middle(Wall(), material, fullSettings(), {sun({0.2, 0.1, 1})});
    expectNear(drawn, displayedBytes(reflectedLight(surface, {0.2, 0.1, 1}, eye)), 2.0);
}

TEST(FullShading, ClearCoat) {
    Json material = metallicRoughness(0.4, 0.7);
    material["extensions"] = {
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.8}, {"clearcoatRoughnessFactor", 0.2}}}};
    ReferenceSurface surface{copper, 0.4, 0.7};
    surface.coat = 0.8;
    surface.coatRoughness = 0.2;
    for (const glm::dvec3& light : {aside, glm::dvec3(0.2, 0.1, 1)})
        expectNear(middle(Wall(), material, fullSettings(), {sun(light)}),
                   displayedBytes(reflectedLight(surface, light, eye)));
}

TEST(FullShading, LightsAddUpBeforeTheDisplaysCurve) {
    const glm::dvec3 other(-1.0, 0.2, 0.7);
    const Color sum = 0.5 * (reflectedLight({copper, 0.2, 0.4}, aside, eye) +
                             reflectedLight({copper, 0.2, 0.4}, other, eye));
    const Color drawn =
        middle(Wall(), metallicRoughness(0.2, 0.4), fullSettings(), {sun(aside), sun(other)});
    if (test::testLimits() == gl::Limits::device)
        expectNear(drawn, displayedBytes(sum), 2.0);
    else
        EXPECT_GE(drawn.r, displayedBytes(sum).r); // colours are summed
}

/// A copper box over a plain floor, with an emissive and a see-through surface.
GltfBuilder sceneOfSorts() {
    GltfBuilder gltf;
    gltf.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}});
    gltf.addMaterial(metallicRoughness(0.7, 0.3));
    gltf.addMaterial({{"emissiveFactor", {0.2, 0.5, 0.1}},
                      {"pbrMetallicRoughness", {{"roughnessFactor", 0.4}}}});
    gltf.addShapeNode(test::box({3, 0.1f, 3}), {{"material", 0}});
    gltf.addNode({{"mesh", gltf.addShape(test::box({0.5f, 0.5f, 0.5f}), {{"material", 1}})},
                  {"translation", {0, 1, 0}}});
    gltf.addNode({{"mesh", gltf.addShape(test::box({0.3f, 0.8f, 0.3f}), {{"material", 2}})},
                  {"translation", {1.2, 0.9, 0.5}}});
    return gltf;
}

/// Every pixel in shadow must equal that of the picture without the light, every other one that of
/// the picture without shadows.
void expectLitOrNot(const RenderSettings& settings, const std::vector<Light>& lights) {
    const GltfBuilder gltf = sceneOfSorts();
    constexpr int width = 96;
    test::TestView view{{{2, 4, 5}, {0, 0.5, 0}, 45.0}, lights, width, width};
    RenderSettings plain = settings;
    plain.shadows = ShadowMethod::none;
    const auto drawn = draw(gltf, view, settings), lit = draw(gltf, view, plain);
    view.lights.front().position = glm::dvec4(0, -1, 0, 0); // from below: nothing is lit
    const auto dark = draw(gltf, view, plain);
    int shaded = 0, other = 0;
    for (std::size_t i = 0; i < drawn.size(); i += 4) {
        const auto off = [&](const std::vector<std::uint8_t>& picture) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(drawn[i + c] - picture[i + c]));
            return most;
        };
        shaded += off(lit) > 1 && off(dark) <= 1;
        other += off(lit) > 1 && off(dark) > 1;
        EXPECT_EQ(drawn[i + 3], 255);
    }
    EXPECT_GT(shaded, 200);
    EXPECT_EQ(other, 0);
}

TEST(FullShading, ShadowTakesTheLightAndNothingElse) {
    for (const ShadowMethod method :
         {ShadowMethod::volumes, ShadowMethod::primitiveMap, ShadowMethod::map}) {
        RenderSettings settings = fullSettings(0.5f);
        settings.shadows = method;
        expectLitOrNot(settings, {sun({1, 2, 0.5})});
        expectLitOrNot(settings, {test::pointLight({1.5, 3, 1})});
    }
}

TEST(FullShading, TheTerminatorIsSoftWhereNormalsAreSmooth) {
    // A wall that the light just grazes, with normals tilted towards the light or not.
    const auto drawn = [](const glm::vec3& normal, const glm::dvec3& light, bool soft,
                          double roughness) {
        Wall wall;
        wall.shape.normals.assign(4, glm::normalize(normal));
        RenderSettings settings = fullSettings();
        settings.softTerminator = soft;
        return middle(wall, metallicRoughness(0.0, roughness), settings, {sun(light)}).r;
    };
    const glm::vec3 turned(1, 0, 1);
    for (const double roughness : {0.5, 1.0}) { // material.frag, surface.frag
        EXPECT_EQ(drawn({0, 0, 1}, aside, true, roughness),
                  drawn({0, 0, 1}, aside, false, roughness));
        EXPECT_NEAR(drawn(turned, {0, 0, 1}, true, roughness),
                    drawn(turned, {0, 0, 1}, false, roughness), 1.0);
        EXPECT_GT(drawn(turned, {1, 0, 0.01}, false, roughness), 150.0);
        if (!test::hasDerivatives()) continue;
        EXPECT_LT(drawn(turned, {1, 0, 0.001}, true, roughness), 60.0);
        EXPECT_LT(drawn(turned, {1, 0, 0.1}, true, roughness) + 10.0,
                  drawn(turned, {1, 0, 0.1}, false, roughness));
    }
}

TEST(FullShading, SeeThroughSurfacesAreInShadowToo) {
    // A pane over the floor, half of it beneath a roof: there as dark as without the light.
    GltfBuilder gltf;
    gltf.addMaterial({{"alphaMode", "BLEND"},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {0.9, 0.5, 0.3, 0.6}}, {"metallicFactor", 0}}}});
    gltf.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
    gltf.addNode({{"mesh", gltf.addShape(test::box({2, 0.01f, 2}), {{"material", 0}})},
                  {"translation", {0, 1, 0}}});
    gltf.addShapeNode(test::box({3, 0.1f, 3}), {{"material", 1}});
    gltf.addNode({{"mesh", gltf.addShape(test::box({1, 0.1f, 2}), {{"material", 1}})},
                  {"translation", {-1.2, 2.5, 0}}});
    const test::TestView view{{{1.5, 3.5, 5}, {0, 1, 0}, 40.0}, {sun({-0.3, 3, 0})}, size, size};
    const auto picture = [&](ShadowMethod method, const glm::dvec3& light) {
        RenderSettings settings = fullSettings(0.5f);
        settings.shadows = method;
        test::TestView seen = view;
        seen.lights = {sun(light)};
        return draw(gltf, seen, settings);
    };
    const glm::dvec3 light(-0.3, 3, 0);
    const auto counted = picture(ShadowMethod::volumes, light);
    const auto lookedUp = picture(ShadowMethod::primitiveMap, light);
    const auto lit = picture(ShadowMethod::none, light);
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "needs float textures";
    int darker = 0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        EXPECT_NEAR(counted[i], lookedUp[i], 2);
        darker += counted[i] + 20 < lit[i];
    }
    EXPECT_GT(darker, 200);
    const Color shaded = at(counted, 11, 19), bright = at(counted, 20, 19);
    EXPECT_LT(shaded.r + 30.0, bright.r);
}

/// A see-through box, green in front and red on its other sides, with its triangles in the file's
/// order or reversed.
std::vector<std::uint8_t> seeThroughBox(bool reversed, bool doubleSided, bool mirrored = false) {
    GltfBuilder gltf;
    gltf.addMaterial({{"alphaMode", "BLEND"},
                      {"doubleSided", doubleSided},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {0.9, 0.9, 0.3, 0.6}}, {"metallicFactor", 0}}}});
    test::Shape shape = test::box({1, 1, 1});
    std::vector<glm::vec3> colors;
    for (const glm::vec3& normal : shape.normals)
        colors.push_back(normal.z > 0.5f ? glm::vec3(0, 1, 1) : glm::vec3(1, 0, 1));
    if (reversed)
        for (std::size_t i = 0, j = shape.indices.size(); i + 3 < j; i += 3) {
            j -= 3;
            for (std::size_t c = 0; c < 3; ++c)
                std::swap(shape.indices[i + c], shape.indices[j + c]);
        }
    Json primitive = gltf.primitiveOf(shape, {{"material", 0}});
    primitive["attributes"]["COLOR_0"] = gltf.addVectors(colors);
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}, {"scale", {mirrored ? -1.0 : 1.0, 1.0, 1.0}}});
    return draw(gltf, {{{1.5, 2, 5}, {0, 0, 0}, 40.0}, {sun({0.5, 2, 3})}, size, size},
                fullSettings(0.5f));
}

TEST(FullShading, TheOrderOfSeeThroughTrianglesMakesNoDifference) {
    for (const bool doubleSided : {false, true})
        for (const bool mirrored : {false, true}) {
            const auto drawn = seeThroughBox(false, doubleSided, mirrored);
            EXPECT_EQ(drawn, seeThroughBox(true, doubleSided, mirrored));
            // The green front hides part of the red back, which shows only if it has two sides.
            const Color seen = at(drawn, size / 2, size / 2);
            EXPECT_GT(seen.g, seen.r + 20.0);
        }
    // Surfaces seen from behind hide part of what is behind them.
    EXPECT_LT(at(seeThroughBox(false, true), size / 2, size / 2).b + 10.0,
              at(seeThroughBox(false, false), size / 2, size / 2).b);
    EXPECT_EQ(seeThroughBox(false, false, true), seeThroughBox(false, false));
}

TEST(FullShading, MasksOfLowerResolutionToo) {
    if (!test::hasDerivatives()) GTEST_SKIP() << "needs derivatives in shaders";
    RenderSettings settings = fullSettings(0.5f);
    settings.maskScale = 2;
    expectLitOrNot(settings, {sun({1, 2, 0.5})});
}

TEST(FullShading, BaseShadingReadsNothingElse) {
    Wall wall;
    Json material = metallicRoughness(1.0, 0.2);
    material["emissiveTexture"] = {{"index", wall.texture({{9, 9, 9, 255}})}};
    material["emissiveFactor"] = {1, 1, 1};
    wall.finish(material);
    const auto document = parseGltf(wall.gltf.glb(), "test.glb");
    Scene scene = flattenScene(document, 0.0, {"", Shading::base});
    EXPECT_TRUE(decodeImages(document, scene).empty());
    EXPECT_TRUE(scene.materials.front().isPlain());
    Scene full = flattenScene(document, 0.0);
    EXPECT_EQ(decodeImages(document, full).size(), 1u);
}

} // namespace
} // namespace edgeshade
