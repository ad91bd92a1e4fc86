// Meshes in many places with one geometry: masks match rays for every method, and nothing is stored
// twice.
#include "src/gl/headless_context.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/bounded_layers.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <set>

namespace edgeshade::test {
namespace {

glm::dmat4 at(const glm::dvec3& place, double turn = 0.0, const glm::dvec3& scale = glm::dvec3(1)) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), place);
    return glm::scale(glm::rotate(moved, turn, glm::normalize(glm::dvec3(0.2, 1, 0.1))), scale);
}

/// A trunk with two boards on it, one of them open.
Batch tree() {
    return SceneBuilder()
        .box({-0.1f, 0, -0.1f}, {0.1f, 1, 0.1f})
        .box({-0.5f, 0.5f, -0.4f}, {0.5f, 0.6f, 0.4f})
        .quad({-0.3f, 0.9f, 0.3f}, {0.3f, 0.9f, 0.3f}, {0.3f, 0.9f, -0.3f}, {-0.3f, 0.9f, -0.3f})
        .scene()
        .batches.front();
}

/// A floor with the mesh in these places.
Scene planted(const Batch& mesh, const std::vector<glm::dmat4>& places) {
    Scene scene = SceneBuilder().floor(6).scene();
    for (const glm::dmat4& place : places) {
        Batch& batch = scene.batches.emplace_back(mesh);
        batch.worldFromBatch = place;
    }
    return scene;
}

/// The same with a separate geometry for every batch.
Scene repeated(Scene scene) {
    for (Batch& batch : scene.batches)
        batch.geometry = CopyOnWrite(Geometry(*batch.geometry));
    return scene;
}

/// Rotated, mirrored, stretched, one within another's reach.
std::vector<glm::dmat4> grove() {
    return {at({0, 0, 0}),
            at({1.5, 0, 0.4}, 1.0, {1, 1.6, 1}),
            at({-1.4, 0, 1.1}, 2.0, {-1, 1, 1}),
            at({0.3, 0.2, -1.6}, 4.0, {0.5, 0.5, 2}),
            at({-1.7, 1.1, -1.2}, 0.5, {1, -1, 1}),
            at({2.2, 0, -1.5}),
            at({3.2, 0, -1.5})};
}

const Camera aside{{5, 4, 6}, {0, 0.4, 0}, 40.0};

/// Boards above one another, one place for every ten of them.
Scene stack(int places) {
    SceneBuilder boards;
    for (int i = 0; i < 10; ++i) {
        const float y = 0.01f * static_cast<float>(i);
        boards.quad({-0.5f, y, 0.5f}, {0.5f, y, 0.5f}, {0.5f, y, -0.5f}, {-0.5f, y, -0.5f});
    }
    std::vector<glm::dmat4> all;
    for (int i = 0; i < places; ++i)
        all.push_back(at({0.01 * i, 0.5 + 0.1 * i, 0.0}));
    return planted(boards.scene().batches.front(), all);
}

/// Slits between boards are thinner than pixels, so that rays and pixels differ there.
void expectAsRepeated(const Scene& scene, const Light& light) {
    const Scene copies = repeated(scene);
    const Camera above{{3, 8, 4}, {0, 0, 0}, 45.0};
    for (const auto method : {MultiplicityMethod::plane, MultiplicityMethod::referenceEdge}) {
        RenderSettings settings;
        settings.multiplicity = method;
        const Outcome shared = run({scene, above, light}, settings);
        const Outcome wanted = run({copies, above, light}, settings);
        EXPECT_LE(shared.wrongBeyondOnePixel, wanted.wrongBeyondOnePixel);
        EXPECT_LE(shared.wrong, wanted.wrong + 5);
        EXPECT_LE(wanted.wrongBeyondOnePixel, 10);
        EXPECT_GT(shared.shadow, 500);
    }
}

} // namespace

TEST(Instances, CastWhatRaysSay) {
    const Scene scene = planted(tree(), grove());
    for (const Light& light : {sun({0.4, 1, 0.3}), sun({1, 0.2, -0.4}), pointLight({0.5, 2.5, 1}),
                               pointLight({0.2, 0.7, 0.15}), pointLight({-1.4, 0.55, 1.1})})
        expectRight(Case{scene, aside, light});
}

TEST(Instances, CastWhatRaysSayWithTheEyeAmongThem) {
    const Scene scene = planted(tree(), grove());
    for (const glm::dvec3& eye : {glm::dvec3(0.02, 0.3, 0.03), glm::dvec3(1.4, 0.7, 0.5)})
        for (const Light& light : {sun({0.4, 1, 0.3}), pointLight({0.5, 2.5, 1})})
            expectRight(Case{scene, {eye, {2, 0.1, -1}, 70.0}, light}, MultiplicityMethod::plane);
}

TEST(Instances, CastIntoTheViewFromOutsideOfIt) {
    const Scene scene = planted(tree(), {at({1.5, 0, 0}, 3.14159), at({1.6, 0, 0.4}, 3.14159)});
    expectRight(Case{scene, {{0, 5, 0.01}, {0, 0, 0}, 15.0}, sun({1, 0.5, 0})},
                MultiplicityMethod::plane);
}

TEST(Instances, CullBacksWhereTheyAreMirrored) {
    Scene scene = planted(tree(), grove());
    scene.culls = true;
    for (Material& material : scene.materials)
        material.doubleSided = false;
    for (const Light& light : {sun({0.4, 1, 0.3}), pointLight({0.5, 2.5, 1})})
        expectRight(Case{scene, aside, light}, MultiplicityMethod::plane);
}

TEST(Instances, AreDrawnAsRepeatedMeshesAre) {
    const Scene scene = planted(tree(), grove());
    const TestView view{aside, {sun({0.4, 1, 0.3}), pointLight({0.5, 2.5, 1})}, 160, 120};
    EXPECT_EQ(drawScene(scene, view, {}), drawScene(repeated(scene), view, {}));
}

TEST(Instances, ThatOverlapTooOftenComeInGroupsAsAWhole) {
    const Scene scene = stack(40);
    const Light above = sun({0, 1, 0});
    const LayerBound bound = test::boundLayers(loadedOf(scene).layerCasters(), above, stencilLimit);
    ASSERT_GT(bound.groupCount, 1u);
    ASSERT_EQ(bound.groupOf.size(), 2u + 40 * 20);
    for (int place = 0; place < 40; ++place) {
        const auto first = bound.groupOf.begin() + 2 + 20 * place;
        EXPECT_EQ(std::set<std::uint32_t>(first, first + 20).size(), 1u) << place;
    }
    expectAsRepeated(scene, above);
    expectAsRepeated(scene, pointLight({0, 9, 0}));
}

TEST(Instances, ThatAloneAreTooManyLayersComeTriangleByTriangle) {
    SceneBuilder boards;
    for (int i = 0; i < 300; ++i) {
        const float y = 0.5f + 0.003f * static_cast<float>(i);
        boards.quad({-0.5f, y, 0.5f}, {0.5f, y, 0.5f}, {0.5f, y, -0.5f}, {-0.5f, y, -0.5f});
    }
    const Scene scene = planted(boards.scene().batches.front(), {at({0, 0, 0}), at({2, 0, 0})});
    expectAsRepeated(scene, sun({0, 1, 0}));
}

TEST(Instances, GroupsOfThemShareTheirRecords) {
    gl::HeadlessContext context(testPicture(16, 16));
    std::size_t bytes[2];
    for (const int half : {0, 1}) {
        const LoadedScene loaded = loadedOf(half == 0 ? stack(40) : repeated(stack(40)));
        FrameLight light{sun({0, 1, 0}), {}, true, {}};
        light.layers = test::boundLayers(loaded.layerCasters(), light.light, stencilLimit);
        OverflowGroups groups;
        groups.upload(loaded, {light}, {});
        for (auto& group : *groups.of(light, VolumeLayout::planePairs))
            for (BatchVolumes& volumes : group)
                volumes.planePairs->uploadAllPairs();
        bytes[half] = groups.sideBytes();
    }
    EXPECT_LT(bytes[0] * 10, bytes[1]);
}

TEST(Instances, AreOnTheGpuOnce) {
    gl::HeadlessContext context(testPicture(16, 16));
    const auto uploaded = [&](std::size_t places) {
        const std::vector<glm::dmat4> all(places, at({0, 0, 0}));
        const LoadedScene loaded = loadedOf(planted(tree(), all));
        GpuScene gpu = uploadScene(loaded, VolumeRecords(), context.capabilities());
        EXPECT_EQ(gpu.batches.back().surfaces, gpu.batches.at(1).surfaces);
        gpu.batches.back().volumes.planePairs->uploadAllPairs();
        return gpu.shadowBytes();
    };
    EXPECT_EQ(uploaded(50), uploaded(2));
}

TEST(Instances, SeeASunFromOneDirectionWithOneList) {
    gl::HeadlessContext context(testPicture(64, 64));
    std::vector<glm::dmat4> places;
    for (int i = 0; i < 20; ++i)
        places.push_back(at({0.5 * (i % 5) - 1, 0, 0.5 * (i / 5) - 1}));
    const LoadedScene loaded = loadedOf(planted(tree(), places));
    const auto listsFor = [&](const Light& light) {
        RenderSettings settings;
        settings.layout = SidesLayout::notInstanced;
        Renderer renderer(settings, context.capabilities());
        GpuScene gpu = uploadScene(loaded, renderer.settings().records(), context.capabilities());
        renderer.draw(gpu, test::boundedFrame(loaded.scene, false,
                                              {frustumOf(aside, 1.0), 64, 64, {light}, {}}));
        return renderer.volumes()->silhouettes()->made();
    };
    EXPECT_EQ(listsFor(sun({0.4, 1, 0.3})), 2u) << "the floor has one, too";
    EXPECT_EQ(listsFor(pointLight({0.5, 2.5, 1})), 21u);
}

TEST(Instances, AreSeenAsFarAsRepeatedMeshesAre) {
    const Scene scene = planted(tree(), grove());
    const Scene copies = repeated(scene);
    for (int i = 0; i < 60; ++i) {
        const double turn = 0.37 * i, radius = 0.5 + 0.15 * i;
        const Camera camera{{radius * std::cos(turn), 0.3 + 0.05 * i, radius * std::sin(turn)},
                            {0.5, 0.5, 0.1 * (i % 7)},
                            i % 3 == 0 ? 20.0 : 60.0};
        const FrameRequest request{frustumOf(camera, 1.3), 130, 100, {sun({0, 1, 0})}, {}};
        const FrameView view = makeFrameView(scene, request, worldBounds(scene));
        const FrameView wanted = makeFrameView(copies, request, worldBounds(copies));
        EXPECT_EQ(view.near(), wanted.near());
        EXPECT_EQ(view.farthestDepth, wanted.farthestDepth);
        EXPECT_EQ(view.visible.low, wanted.visible.low);
        EXPECT_EQ(view.visible.high, wanted.visible.high);
        EXPECT_EQ(view.slopes.right.low, wanted.slopes.right.low);
        EXPECT_EQ(view.slopes.up.high, wanted.slopes.up.high);
        for (std::size_t b = 0; b < scene.batches.size(); ++b)
            EXPECT_LE(view.nearestDepths[b], wanted.nearestDepths[b]);
    }
}

} // namespace edgeshade::test
