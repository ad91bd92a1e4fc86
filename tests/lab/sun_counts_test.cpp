// Sun positions counted by rays are those for which the oracle says lit, without a difference.
#include "src/lab/exact_judge.hpp"
#include "src/lab/sun_counts.hpp"
#include "src/lab/texture_alpha.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/framing.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade::lab {
namespace {

/// Directions from horizon to horizon, the last two along walls and floors.
std::vector<glm::dvec3> day(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double turn = 3.1 * (i + 0.5) / count;
        directions.emplace_back(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn));
    }
    directions.emplace_back(0, 1, 1);
    directions.emplace_back(1, 0, 0);
    return directions;
}

Question questionOf(const LoadedScene& loaded, const std::vector<glm::dvec3>& directions, int width,
                    int height, bool orthographic) {
    const double aspect = static_cast<double>(width) / height;
    FrameRequest request;
    const Box bounds = worldBounds(loaded.scene);
    request.frustum =
        frustumOf(framingCamera(bounds, 45.0, aspect), aspect,
                  orthographic ? std::optional(0.8 * bounds.diagonal()) : std::nullopt);
    request.width = width;
    request.height = height;
    for (const glm::dvec3& direction : directions)
        request.lights.push_back({glm::dvec4(direction, 0.0)});
    Question question;
    question.lights = request.lights;
    question.scene = &loaded.scene;
    question.castMasked = loaded.settings.castMasked;
    question.cutoutsCast = loaded.cutoutsCast;
    const FrameView view = makeFrameView(loaded.scene, request, bounds);
    question.frustum = view.frustum;
    question.near = view.near();
    question.width = width;
    question.height = height;
    return question;
}

/// Compares the counts of all pixels with the judge's; returns the mean share lit.
double compare(const LoadedScene& loaded, int positions, int width, int height,
               bool orthographic = false) {
    const std::vector<glm::dvec3> directions = day(positions);
    const Oracle oracle(questionOf(loaded, directions, width, height, orthographic),
                        textureAlpha(loaded));
    const std::vector<PixelSurface> surfaces = pixelSurfaces(oracle, {});
    const std::vector<std::uint16_t> counts =
        litCounts(oracle, surfaces, directions, [](double share) { EXPECT_LE(share, 1.0); });
    std::size_t wrong = 0, visible = 0, lit = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const Answer answer = judge(oracle, i).answer;
        EXPECT_EQ(surfaces[i].area > 0.0, answer.surface) << "pixel " << i;
        wrong += counts[i] != answer.lit.countOfFirst(directions.size());
        visible += answer.surface;
        lit += counts[i];
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(visible, counts.size() / 100);
    return static_cast<double>(lit) / static_cast<double>(visible * directions.size());
}

TEST(SunCounts, AreTheOracles) {
    for (const double away : {0.0, 1e6}) {
        test::SceneBuilder yard = test::yard();
        yard.placedBy(glm::translate(glm::dmat4(1.0), glm::dvec3(away, 0.5 * away, -away)));
        for (const bool orthographic : {false, true}) {
            const double lit = compare(test::loadedOf(yard.scene()), 40, 120, 80, orthographic);
            EXPECT_GT(lit, 0.3);
            EXPECT_LT(lit, 0.95);
        }
    }
}

TEST(SunCounts, OfSeeThroughAndMaskedCastersAreTheOracles) {
    Material leaves, glass;
    leaves.alphaMode = AlphaMode::mask;
    leaves.baseColorFactor.a = 0.25f; // cut out everywhere
    glass.alphaMode = AlphaMode::blend;
    test::SceneBuilder builder = test::SceneBuilder().floor(5).box({-1, 0, -1}, {0, 1, 0});
    builder.material(leaves).floor(1.5f, 2.0f).material(glass).floor(1.0f, 3.0f);
    LoadedScene loaded = test::loadedOf(builder.scene());
    const double none = compare(loaded, 30, 90, 60);
    loaded.cutoutsCast = true;
    EXPECT_EQ(compare(loaded, 30, 90, 60), none);
    loaded.cutoutsCast = false;
    loaded.settings.castMasked = true;
    EXPECT_LT(compare(loaded, 30, 90, 60), none);
}

TEST(SunCounts, OfCutScenesAreTheOracles) {
    double cut = 0.0;
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        LoadedScene loaded = test::loadedOf(test::yard().scene());
        Section section;
        section.planes = {glm::dvec4(-0.3, -1, 0.2, 0.9)};
        section.shadows = shadows;
        cutScene(loaded, section);
        const double lit = compare(loaded, 30, 90, 60);
        if (shadows == SectionShadows::cut)
            cut = lit;
        else
            EXPECT_LT(lit, cut);
    }
}

// Each shared scene on its own, so that a run may pick one.
class SharedSunCounts : public testing::TestWithParam<const char*> {};

TEST_P(SharedSunCounts, AreTheOracles) {
    const std::filesystem::path file = std::filesystem::path(EDGESHADE_SHARED_SCENES) / GetParam();
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    LoadedScene loaded = loadScene(file, std::nullopt);
    loaded.scene.culls = cullsByDefault;
    for (const bool orthographic : {false, true})
        compare(loaded, 22, 160, 120, orthographic);
}

INSTANTIATE_TEST_SUITE_P(Short, SharedSunCounts, testing::Values("temple.glb"));
INSTANTIATE_TEST_SUITE_P(Long, SharedSunCounts,
                         testing::Values("bunny.draco.glb", "car.draco.glb", "city.draco.glb",
                                         "duck.glb", "engine.glb", "garden.draco.glb",
                                         "hospital-electrical.glb", "oaktree.glb",
                                         "truck.draco.glb"));

} // namespace
} // namespace edgeshade::lab
