// The first one of coinciding surfaces in the file is visible, with every shadow method
// (docs/method.md, C36).

#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::TestView;

constexpr int width = 160, height = 120;
const Camera above{{3, 4, 2}, {0, 0, 0}, 50.0};
const glm::vec4 red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1);

/// A rectangle in the plane y = 0, facing up or down.
struct Sheet {
    glm::vec2 low, high;
    bool up;
    glm::vec4 color;
};

Scene sceneOf(const std::vector<Sheet>& sheets) {
    SceneBuilder builder;
    for (const Sheet& sheet : sheets) {
        const glm::vec3 a(sheet.low.x, 0, sheet.high.y), b(sheet.high.x, 0, sheet.high.y);
        const glm::vec3 c(sheet.high.x, 0, sheet.low.y), d(sheet.low.x, 0, sheet.low.y);
        sheet.up ? builder.quad(a, b, c, d) : builder.quad(d, c, b, a);
    }
    Scene scene = builder.scene();
    auto& colors = scene.batches.front().geometry.edit().colors;
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] = sheets[i / 6].color;
    return scene;
}

std::vector<std::uint8_t> draw(const Scene& scene, const std::vector<Light>& lights,
                               ShadowMethod method) {
    RenderSettings settings;
    settings.shadows = method;
    return test::drawScene(scene, {above, lights, width, height}, settings);
}

/// Sheets in one plane cast no shadow that is visible from the lights' side.
void expectThePictureWithoutShadows(const Scene& scene,
                                    std::initializer_list<ShadowMethod> methods) {
    for (const auto& lights : {std::vector<Light>{pointLight({0.5, 3, 1})},
                               std::vector<Light>{sun({0.3, 1, 0.2}), pointLight({0.5, 3, 1})}}) {
        const auto unshadowed = draw(scene, lights, ShadowMethod::none);
        for (const ShadowMethod method : methods)
            EXPECT_EQ(draw(scene, lights, method), unshadowed);
    }
}

TEST(CoincidingSurfaces, TheFirstOfTheFileIsSeen) {
    // One separate sheet in the same plane, and two twins with opposite winding.
    for (const bool apartIsUp : {false, true})
        for (const bool firstIsUp : {false, true}) {
            const Scene scene = sceneOf({{{1.2, -1}, {1.8, 1}, apartIsUp, red},
                                         {{-1, -1}, {1, 1}, firstIsUp, green},
                                         {{-1, -1}, {1, 1}, !firstIsUp, blue}});
            expectThePictureWithoutShadows(scene,
                                           {ShadowMethod::primitiveMap, ShadowMethod::volumes});
            // On hardware, depths of different triangles in a plane may differ, whatever the
            // method.
            if (!test::drawsOnProcessor()) continue;
            const auto picture = draw(scene, {sun({0.3, 1, 0.2})}, ShadowMethod::primitiveMap);
            const std::size_t middle = 4 * (height / 2 * width + width / 2);
            EXPECT_GT(picture[middle + 1], 0) << "green";
            EXPECT_EQ(picture[middle + 2], 0) << "blue";
        }
}

TEST(CoincidingSurfaces, OverlappingSheetsKeepTheirOrder) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "needs float textures";
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 4; ++i) {
        std::vector<Sheet> sheets;
        for (int s = 0; s < 12; ++s) {
            const glm::vec2 low = 3.0f * glm::vec2(unit(random), unit(random)) - 2.0f;
            const glm::vec2 size = 0.2f + 1.5f * glm::vec2(unit(random), unit(random));
            sheets.push_back({low, low + size, unit(random) < 0.5f,
                              glm::vec4(unit(random), unit(random), unit(random), 1.0f)});
        }
        expectThePictureWithoutShadows(sceneOf(sheets), {ShadowMethod::primitiveMap});
    }
}

} // namespace
} // namespace edgeshade
