// Fans of silhouette edges as caps cover the same pixels as caps of all casting triangles, and take
// fewer vertices.
#include "src/gl/headless_context.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/planned_volumes.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::Random;
using test::SceneBuilder;
using test::sun;

constexpr int width = 120, height = 90;

/// A ball of radius 1 with bumps, so that its silhouettes have loops within loops.
class BumpyBall {
  public:
    static constexpr int columns = 64, rows = 32;

    explicit BumpyBall(Random& random) {
        for (int j = 0; j <= rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const double up = glm::pi<double>() * j / rows;
                const double around = glm::two_pi<double>() * i / columns;
                const double radius = j % rows == 0 ? 1.0 : random.uniform(0.98, 1.02);
                points_.emplace_back(radius * std::sin(up) * std::cos(around),
                                     radius * std::cos(up),
                                     radius * std::sin(up) * std::sin(around));
            }
    }

    /// `holes`: this many of 16 quads are left out.
    Scene scene(Random& random, int holes, const glm::dmat4& placing) const {
        SceneBuilder builder;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                if (random.below(16) < holes) continue;
                const glm::vec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1),
                                d = at(i, j + 1);
                if (j > 0) builder.triangle(a, b, c);
                if (j + 1 < rows) builder.triangle(a, c, d);
            }
        return builder.placedBy(placing).scene();
    }

    glm::dvec3 point(Random& random) const {
        return points_[static_cast<std::size_t>(random.below(static_cast<int>(points_.size())))];
    }

  private:
    glm::vec3 at(int i, int j) const {
        const int column = j % rows == 0 ? 0 : i % columns; // the poles are one point each
        return points_[static_cast<std::size_t>(j * columns + column)];
    }

    std::vector<glm::vec3> points_;
};

/// A screen that receives the shadows: all around, or across the way of a directional light, which
/// the former would keep out.
Batch screenFor(const Light& light, const glm::dvec3& middle) {
    if (light.position.w != 0.0)
        return SceneBuilder().box({20, 20, 20}, {-20, -20, -20}).scene().batches.front();
    const glm::dvec3 towards(light.position);
    const glm::dvec3 aside = glm::normalize(glm::cross(towards, {0.3, 0.5, 0.7}));
    const glm::dvec3 up = glm::cross(aside, towards);
    const auto at = [&](double x, double y) {
        return glm::vec3(middle + 30.0 * (x * aside + y * up) - 9.0 * towards);
    };
    return SceneBuilder().quad(at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)).scene().batches.front();
}

struct Drawn {
    std::vector<std::uint8_t> mask;
    std::size_t vertexRuns;
};

RenderSettings settingsOf(SilhouetteChoice choice, SidesLayout layout) {
    RenderSettings settings;
    settings.silhouette = choice;
    settings.layout = layout;
    return settings;
}

Drawn drawnBy(Renderer& renderer, const gl::HeadlessContext& context, const LoadedScene& loaded,
              const FrameView& view) {
    GpuScene scene = uploadScene(loaded, renderer.settings().records(), context.capabilities());
    renderer.draw(scene, view);
    gl::requireNoError("drawing a test scene");
    return {context.readPixels(), renderer.vertexRuns()};
}

} // namespace

class FannedCaps : public testing::TestWithParam<SidesLayout> {};

TEST_P(FannedCaps, CoverWhatTrianglesDo) {
    Random random(17);
    const BumpyBall ball(random);
    const gl::HeadlessContext context({width, height}); // for all cases: it takes longer than they
    Renderer byProposed(settingsOf(SilhouetteChoice::proposed, GetParam()), context.capabilities());
    Renderer byAll(settingsOf(SilhouetteChoice::all, GetParam()), context.capabilities());
    int fanned = 0, fewer = 0, shadow = 0, lit = 0;
    for (int i = 0; i < 60; ++i) {
        glm::dmat4 placing = glm::translate(glm::dmat4(1.0), 3.0 * random.inCube());
        if (i % 3 == 1) placing = glm::scale(placing, {-0.5, 2.0, 1.0}); // mirrored
        LoadedScene loaded{{}, ball.scene(random, i % 2 ? 1 : 0, placing), {}, {}, {}, {}};
        // The eye just behind a point of the ball, as seen from the light: outlines of shadows
        // cross many near rectangles there.
        const auto inWorld = [&](const glm::dvec3& p) {
            return glm::dvec3(placing * glm::dvec4(p, 1.0));
        };
        const bool isDirectional = i % 4 == 3;
        const glm::dvec3 middle = inWorld({0, 0, 0});
        const glm::dvec3 away = glm::normalize(random.inCube());
        const Light light =
            isDirectional ? sun(away) : pointLight(middle + random.uniform(3, 9) * away);
        loaded.scene.batches.push_back(screenFor(light, middle));
        loaded.planePairs = buildPlanePairs(loaded.scene, false);
        const glm::dvec3 point = inWorld(ball.point(random));
        const glm::dvec3 shone = isDirectional ? -away : point - glm::dvec3(light.position);
        const glm::dvec3 eye = point + random.uniform(0.6, 3.0) * glm::normalize(shone);
        const glm::dvec3 to = random.below(2) ? middle : eye + random.inCube();
        const Camera camera{eye, to, random.uniform(30, 100)};
        DepthChoice depth;
        depth.near = 0.25;
        FrameView view = test::boundedFrame(loaded.scene, loaded.settings.castMasked,
                                            {frustumOf(camera, static_cast<double>(width) / height),
                                             width,
                                             height,
                                             {light},
                                             depth});
        view.mask = true;

        const PlanView planned = planView(view, view.slices.back(), light, placing);
        bool allowed = false;
        for (const ClusterPlan& draw : test::planVolumes(*loaded.planePairs[0], planned).drawn)
            allowed = allowed || (draw.fannedCaps && (draw.frontCaps || draw.backCaps));
        const Drawn proposed = drawnBy(byProposed, context, loaded, view);
        const Drawn all = drawnBy(byAll, context, loaded, view);
        ASSERT_EQ(proposed.mask, all.mask) << "case " << i;
        fanned += allowed;
        fewer += allowed && 4 * proposed.vertexRuns < all.vertexRuns;
        for (std::size_t p = 0; p < all.mask.size(); p += 4)
            (all.mask[p] != 0 ? lit : shadow) += 1;
    }
    EXPECT_GT(fanned, 15);
    EXPECT_GT(fewer, 10);
    EXPECT_GT(shadow, 10'000);
    EXPECT_GT(lit, 10'000);
}

INSTANTIATE_TEST_SUITE_P(Layouts, FannedCaps,
                         testing::Values(SidesLayout::instanced, SidesLayout::notInstanced));

} // namespace edgeshade
