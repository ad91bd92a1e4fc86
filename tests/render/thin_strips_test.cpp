// Sides thinner than the rasteriser's grid: only the rasteriser decides whether they face the eye,
// so that counting by two must give the same pixels as the opposite-vertex records.

#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

constexpr int width = 640, height = 360;

/// A low open ridge of `segments` segments in front of a wall, curved so that its crest is a
/// silhouette. Its sides are seen almost edge-on.
Scene ridge(int segments) {
    const auto ring = [segments](int segment, int vertex) {
        const double p = -0.1 + 0.2 * segment / segments;
        const double radius = vertex == 1 ? 0.30 : 0.28;
        return glm::vec3(glm::dvec3(0.1 + radius * std::cos(p), 1.0 + radius * std::sin(p),
                                    0.02 * (vertex - 1)));
    };
    SceneBuilder builder;
    for (int i = 0; i < segments; ++i)
        for (int k = 0; k < 2; ++k) {
            const glm::vec3 a = ring(i, k), b = ring(i + 1, k), c = ring(i, k + 1),
                            d = ring(i + 1, k + 1);
            builder.triangle(a, b, c).triangle(c, b, d);
        }
    builder.quad({-20, -20, -5}, {20, -20, -5}, {20, 20, -5}, {-20, 20, -5});
    return builder.scene();
}

std::vector<std::uint8_t> maskOf(const Scene& scene, double eyeX, RenderSettings settings) {
    test::TestView view;
    view.camera = {{eyeX, 0.053, 10.0}, {0.0, 0.0, 0.0}, 45.0};
    view.lights = {test::pointLight({0.3, 6.0, -4.5})};
    view.width = width;
    view.height = height;
    view.mask = true;
    view.depth.near = 0.5;
    return test::drawScene(scene, view, settings);
}

TEST(ThinStrips, CountTwiceAsPublishedRecordsDo) {
    RenderSettings oppositeVertices;
    oppositeVertices.multiplicity = MultiplicityMethod::referenceEdge;
    for (const int segments : {250, 500, 1000})
        for (const double eyeX : {0.137, 0.148, 0.159}) {
            const Scene scene = ridge(segments);
            const auto wanted = maskOf(scene, eyeX, oppositeVertices);
            for (const SilhouetteChoice choice :
                 {SilhouetteChoice::all, SilhouetteChoice::proposed}) {
                RenderSettings planePairs;
                planePairs.silhouette = choice;
                const auto drawn = maskOf(scene, eyeX, planePairs);
                int different = 0;
                for (std::size_t i = 0; i < drawn.size(); i += 4)
                    different += drawn[i] != wanted[i] || drawn[i + 3] != wanted[i + 3];
                EXPECT_EQ(different, 0) << segments << " segments, eye at x = " << eyeX;
            }
        }
}

} // namespace
} // namespace edgeshade
