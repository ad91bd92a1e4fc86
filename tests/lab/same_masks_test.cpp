// What is filled otherwise, or left out, changes no mask, but for single pixels at boundaries of
// shadows, where another corner of a side has it on another step of the rasteriser's grid
// (docs/method.md, C14): of extremes, of the scenes that ship and of models of ../shared/scenes,
// where they are there.
#include "src/gl/headless_context.hpp"
#include "src/lab/views.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/shadow/geometry/light_region.hpp"
#include "src/shadow/geometry/vectors.hpp"
#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"
#include "tests/support/scene_builder.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr int width = 160, height = 120;
constexpr double aspect = static_cast<double>(width) / height;
/// Of a mask's pixels, what the grid may turn over: as measured, 2 of 19,200 at the most.
constexpr std::size_t mostTurned = 4;

constexpr std::size_t mostCasters = 200'000; ///< of an extreme, for the time that it takes

const Light highSun = sun({0.4, 1, 0.3}), lowSun = sun({-0.9, 0.25, 0.35});

/// What is seen by which light.
struct View {
    Frustum frustum;
    Light light;
};

/// Draws masks of one scene by several settings.
class Masks {
  public:
    explicit Masks(const LoadedScene& loaded)
        : loaded_(loaded), context_({width, height}),
          scene_(uploadScene(loaded, RenderSettings().records(), context_.capabilities())) {}

    /// `wander`: FrameLight's; 0: the light rests.
    std::vector<std::uint8_t> of(const View& view, const RenderSettings& settings,
                                 double wander = 0.0) {
        FrameRequest request{view.frustum, width, height, {view.light}, {}};
        FrameView frame = makeFrameView(loaded_.scene, loaded_.settings.castMasked, request);
        frame.culls = false;
        frame.mask = true;
        frame.lights.front().atRest = wander == 0.0;
        frame.lights.front().wander = wander;
        prepareScene(scene_, loaded_, frame, settings, context_.capabilities());
        Renderer(settings, context_.capabilities()).draw(scene_, frame);
        gl::requireNoError("drawing a mask");
        return context_.readPixels();
    }

  private:
    const LoadedScene& loaded_;
    gl::HeadlessContext context_;
    GpuScene scene_;
};

using Pixels = std::vector<std::uint8_t>;

std::uint8_t at(const Pixels& mask, int x, int y) {
    return mask[4 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x))];
}

/// Whether a pixel of the mask or of those around it is another than that one.
bool isAtBoundary(const Pixels& mask, int x, int y) {
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i)
            if (at(mask, i, j) != at(mask, x, y)) return true;
    return false;
}

void expectAlike(const Pixels& a, const Pixels& b) {
    std::size_t turned = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (at(a, x, y) == at(b, x, y)) continue;
            ++turned;
            EXPECT_TRUE(isAtBoundary(a, x, y) || isAtBoundary(b, x, y)) << x << ", " << y;
        }
    EXPECT_LE(turned, mostTurned);
}

/// Other ways of filling, and their names.
std::vector<std::pair<const char*, RenderSettings>> ways() {
    RenderSettings byCost;
    byCost.ends = VolumeEnds::byCost;
    RenderSettings scissored;
    scissored.scissors = VolumeScissors::on;
    RenderSettings culled;
    culled.casterCulling = true;
    RenderSettings withoutBacks;
    withoutBacks.cullSolids = true;
    return {{"ends by cost", byCost},
            {"volume scissors", scissored},
            {"casters culled", culled},
            {"backs of solids", withoutBacks}};
}

/// A light beside one, two thirds of the way to the rim of where that one may wander.
Light beside(const Light& light, double wander) {
    const glm::dvec3 place(light.position);
    const glm::dvec3 across = light.position.w == 0.0
                                  ? glm::length(place) * axesAlong(unitOf(place))[0]
                                  : glm::dvec3(1, 0, 0);
    return light.at(light.position + glm::dvec4(0.66 * wander * across, 0.0));
}

void expectSame(const LoadedScene& loaded, const std::vector<View>& views) {
    Masks masks(loaded);
    const double diagonal = worldBounds(loaded.scene).diagonal();
    RenderSettings culling;
    culling.casterCulling = true;
    for (std::size_t i = 0; i < views.size(); ++i) {
        RenderSettings plain;
        plain.scissors = VolumeScissors::off;
        const auto mask = masks.of(views[i], plain);
        for (const auto& [name, settings] : ways()) {
            SCOPED_TRACE("view " + std::to_string(i) + ", " + name);
            expectAlike(mask, masks.of(views[i], settings));
        }
        SCOPED_TRACE("view " + std::to_string(i) + ", a light that wanders");
        const Light& light = views[i].light;
        const double wander = mostWander(light, diagonal) / 3.0;
        masks.of({views[i].frustum, beside(light, wander)}, culling, wander);
        expectAlike(mask, masks.of(views[i], culling, wander));
    }
}

std::vector<Extreme> quickExtremes() {
    std::vector<Extreme> quick;
    for (const auto& theme :
         {placeExtremes(), lightExtremes(), viewExtremes(), shapeExtremes(), amountExtremes()})
        for (const Extreme& extreme : theme)
            if (!extreme.takesLong && extreme.leastTriangles <= mostCasters)
                quick.push_back(extreme);
    return quick;
}

/// Some of the lab's views, in their lights and in suns.
std::vector<View> viewsOf(const Scene& scene) {
    std::vector<View> views;
    for (const lab::LabView& view : lab::labViews(scene, 3, 55.0, aspect)) {
        views.push_back({view.frustum, view.light});
        views.push_back({view.frustum, views.size() % 4 == 1 ? highSun : lowSun});
    }
    return views;
}

TEST(SameMasks, OfExtremes) {
    for (const Extreme& extreme : quickExtremes()) {
        SCOPED_TRACE(extreme.name);
        std::vector<View> views;
        const Frustum frustum = extreme.frustum.value_or(frustumOf(extreme.camera, aspect));
        if (!extreme.lights.empty()) views.push_back({frustum, extreme.lights.front()});
        views.push_back({frustum, lowSun});
        expectSame(extreme.load(), views);
    }
}

std::vector<std::filesystem::path> models() {
    std::vector<std::filesystem::path> paths;
    for (const char* folder : {EDGESHADE_ASSETS, EDGESHADE_SHARED_SCENES})
        if (std::filesystem::is_directory(folder))
            for (const auto& entry : std::filesystem::directory_iterator(folder))
                if (entry.path().extension() == ".glb") paths.push_back(entry.path());
    return paths;
}

/// Under a slab, which the near rectangle is in the shadow of; below the floor, which is a cluster
/// of its own, a sheet that is folded along its silhouette: all that counts by two, and nobody sees
/// its shadow.
Scene foldedBelowFloor() {
    SceneBuilder builder;
    for (int x = -9; x < 9; ++x)
        for (int z = -9; z < 9; ++z) {
            const glm::vec3 a(2 * x, 0, 2 * z);
            builder.quad(a, a + glm::vec3(0, 0, 2), a + glm::vec3(2, 0, 2), a + glm::vec3(2, 0, 0));
        }
    builder.box({-4, 4, -4}, {4, 5, 4});
    const glm::vec3 a(-0.5, -1, 3), b(0.5, -1, 3), down(0, -0.5, 0.5);
    builder.quad(b, a, a + down, b + down);
    builder.quad(a, b, b + 1.5f * down - glm::vec3(0, 0.1, 0), a + 1.5f * down);
    return builder.scene();
}

TEST(SameMasks, WhereAllThatCountsByTwoIsLeftOut) {
    const LoadedScene scene = loaded(foldedBelowFloor());
    expectSame(scene, {{frustumOf({{0, 2, 0}, {0.2, 0, 3}, 50.0}, aspect), {{0, 40, 0, 1}}}});
}

TEST(SameMasks, OfModels) {
    for (const std::filesystem::path& path : models()) {
        SCOPED_TRACE(path.filename().string());
        const LoadedScene loaded = loadScene(path, std::nullopt);
        expectSame(loaded, viewsOf(loaded.scene));
    }
}

} // namespace
} // namespace edgeshade::test
