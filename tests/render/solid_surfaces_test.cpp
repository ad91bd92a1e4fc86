// Backs of solids aren't drawn where nobody can see them, and no picture tells
// (docs/method.md, C44).
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/solid_surfaces.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;
using test::sun;
using test::TestView;

constexpr int width = 96, height = 64;
const Camera outside{{4, 3, 5}, {0, 0.6, 0}, 50.0};
const Camera within{{0.3, 1.1, 0.4}, {-2, 0.9, -1}, 80.0};

Material ofKind(AlphaMode mode) {
    Material material;
    material.alphaMode = mode;
    return material;
}

SolidSurfaces solidsOf(const SceneBuilder& builder) {
    const Scene scene = builder.scene();
    return solidSurfacesOf(scene.batches.front(), scene.materials);
}

SceneBuilder street() {
    return SceneBuilder()
        .floor(5)
        .box({-1, 0, -1}, {1, 2, 1})
        .quad({1.5f, 0, 1}, {2.5f, 0, 1}, {2.5f, 1, 0.5f}, {1.5f, 1, 0.5f})
        .box({2, 0.1f, -2}, {3, 1, -1})
        .box({-2, 2, 3}, {-3, 0, 2}); // wound inwards
}

TEST(SolidSurfaces, AreTheTrianglesOfSolidsAlone) {
    const SolidSurfaces solids = solidsOf(street());
    ASSERT_EQ(solids.bounds.size(), 2u);
    EXPECT_EQ(solids.bounds[0].low, glm::dvec3(-1, 0, -1));
    EXPECT_EQ(solids.bounds[1].high, glm::dvec3(3, 1, -1));
    ASSERT_EQ(solids.ofTriangle.size(), 40u);
    for (std::size_t t = 0; t < 40; ++t) {
        const bool first = t >= 2 && t < 14, second = t >= 16 && t < 28;
        EXPECT_EQ(solids.ofTriangle[t], first ? 0u : second ? 1u : SolidSurfaces::none) << t;
    }
}

TEST(SolidSurfaces, OfOtherMaterialsAndOfWhatDeformsThereAreNone) {
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend})
        EXPECT_TRUE(solidsOf(SceneBuilder().material(ofKind(mode)).box({0, 0, 0}, {1, 1, 1}))
                        .bounds.empty());
    Scene scene = SceneBuilder().box({0, 0, 0}, {1, 1, 1}).scene();
    scene.batches.front().deformation = std::make_shared<const Deformation>();
    EXPECT_TRUE(solidSurfacesOf(scene.batches.front(), scene.materials).bounds.empty());
}

std::vector<std::uint8_t> draw(const Scene& scene, const TestView& view, bool cullSolids,
                               ShadowMethod shadows = ShadowMethod::volumes) {
    RenderSettings settings;
    settings.shadows = shadows;
    settings.cullSolids = cullSolids;
    return test::drawScene(scene, view, settings);
}

/// From outside, from within the first box, where it is cut by the near plane, from above without
/// perspective, and in slices of depth.
std::vector<TestView> views() {
    const std::vector<Light> lights = {sun({0.4, 1, 0.3})};
    std::vector<TestView> all = {{outside, lights, width, height},
                                 {within, lights, width, height},
                                 {outside, lights, width, height},
                                 {outside, lights, width, height},
                                 {outside, lights, width, height}};
    all[2].depth.near = 5.5;
    all[3].frustum = frustumOf(outside, static_cast<double>(width) / height);
    all[3].frustum->orthographic = true;
    all[3].frustum->low = {-4, -3};
    all[3].frustum->high = {4, 3};
    all[4].depth.slices = 5;
    return all;
}

TEST(SolidSurfaces, ThePictureIsTheSame) {
    for (const bool mirrored : {false, true})
        for (const ShadowMethod shadows : {ShadowMethod::volumes, ShadowMethod::map}) {
            SceneBuilder builder = street();
            if (mirrored) builder.placedBy(glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0}));
            const Scene scene = builder.scene();
            for (std::size_t i = 0; i < views().size(); ++i)
                EXPECT_EQ(draw(scene, views()[i], true, shadows),
                          draw(scene, views()[i], false, shadows))
                    << "view " << i << (mirrored ? ", mirrored" : "");
        }
}

/// The picture of a box wound inwards that is taken for a solid, which no scene's would be.
std::vector<std::uint8_t> drawWronglySolid(const Camera& camera, bool cullSolids) {
    LoadedScene loaded;
    loaded.scene = SceneBuilder().floor(5, -1).box({1, 2, 1}, {-1, 0, -1}).scene();
    loaded.planePairs = buildPlanePairs(loaded.scene, false);
    const gl::HeadlessContext context(test::testPicture(width, height));
    RenderSettings settings;
    settings.layout = bestLayout(context.capabilities());
    settings.background = {1.0f, 0.0f, 1.0f};
    settings.cullSolids = cullSolids;
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    SurfaceChunk& chunk = gpu.batches.front().surfaces->front();
    chunk.firstSolidIndex = 6;
    chunk.solids.push_back(Box{{-1, 0, -1}, {1, 2, 1}});
    gpu.solidsLast = true;
    const FrameView view = makeFrameView(
        loaded.scene, false,
        {frustumOf(camera, static_cast<double>(width) / height), width, height, {sun({0, 1, 0})}});
    prepareScene(gpu, loaded, view, settings, context.capabilities());
    Renderer(settings, context.capabilities()).draw(gpu, view);
    return context.readPixels();
}

// That pictures are the same says nothing if nothing is left out.
TEST(SolidSurfaces, BacksAreLeftOutFromOutsideAndDrawnFromWithin) {
    EXPECT_NE(drawWronglySolid(outside, true), drawWronglySolid(outside, false));
    EXPECT_EQ(drawWronglySolid(within, true), drawWronglySolid(within, false));
}

} // namespace
} // namespace edgeshade
