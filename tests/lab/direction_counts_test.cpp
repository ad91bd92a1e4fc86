// Counted sun positions, compared with rays for the same ones.
#include "src/gl/headless_context.hpp"
#include "src/lab/point_counts.hpp"
#include "src/render/accumulation/direction_counts.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::lab {
namespace {

/// A day's arc of directions from horizon to horizon: more than one picture can sum.
std::vector<glm::dvec3> arc(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double turn = 3.1 * (i + 0.5) / count;
        directions.push_back(
            glm::normalize(glm::dvec3(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn))));
    }
    return directions;
}

LitCounts drawn(const LoadedScene& loaded, const FrameRequest& request,
                const std::vector<glm::dvec3>& directions) {
    const gl::HeadlessContext context({request.width, request.height});
    RenderSettings settings;
    settings.layout = bestLayout(context.capabilities());
    Renderer renderer(settings, context.capabilities());
    GpuScene scene = uploadScene(loaded, settings.records(), context.capabilities());
    double last = 0.0;
    const LitCounts counts = countDirections(loaded, request, directions, renderer, scene,
                                             context.capabilities(), [&](double share) {
                                                 EXPECT_GT(share, last);
                                                 last = share;
                                             });
    EXPECT_EQ(last, directions.empty() ? 0.0 : 1.0);
    return counts;
}

FrameRequest lookingAt(const LoadedScene& loaded) {
    FrameRequest request;
    request.frustum = frustumOf(framingCamera(worldBounds(loaded.scene), 45.0, 1.5), 1.5);
    request.width = 150;
    request.height = 100;
    return request;
}

} // namespace

TEST(DirectionCounts, AreThoseOfRays) {
    const LoadedScene loaded = test::loadedOf(test::yard().scene());
    FrameRequest request = lookingAt(loaded);
    const std::vector<glm::dvec3> directions = arc(70);
    const LitCounts counts = drawn(loaded, request, directions);
    ASSERT_EQ(counts.lights, 70u);

    Question question;
    question.scene = &loaded.scene;
    for (const glm::dvec3& direction : directions)
        question.lights.push_back({glm::dvec4(direction, 0.0)});
    request.lights = {question.lights.front()};
    const FrameView view = makeFrameView(loaded.scene, request, worldBounds(loaded.scene));
    question.frustum = view.frustum;
    question.near = view.near();
    question.width = request.width;
    question.height = request.height;
    const WrongSums wrong = PointOracle(question, {}).compare(counts, directions.size());
    EXPECT_GT(wrong.visiblePixels, 3000u);
    EXPECT_EQ(wrong.beyond1pxNotTied, 0u);
    EXPECT_LT(wrong.percent(), 0.5);
}

TEST(DirectionCounts, OfNoDirectionsShowSurfacesInTheDark) {
    const LoadedScene loaded = test::loadedOf(test::yard().scene());
    const FrameRequest request = lookingAt(loaded);
    const LitCounts none = drawn(loaded, request, {}), some = drawn(loaded, request, arc(3));
    EXPECT_EQ(none.lights, 0u);
    EXPECT_EQ(std::ranges::count(none.lit, 0), static_cast<std::ptrdiff_t>(none.lit.size()));
    for (std::size_t i = 0; i < none.surface.size(); ++i)
        EXPECT_EQ(none.surface[i] > 0, some.surface[i] > 0);
}

} // namespace edgeshade::lab
