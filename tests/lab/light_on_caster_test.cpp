// Lights on casters and suns in the planes of walls, rotated and moved by ordinary numbers,
// compared with rays for every method and layout (docs/method.md, C47).
#include "src/shadow/lights/light_contact.hpp"
#include "src/shadow/lights/scene_lights.hpp"
#include "tests/lab/contender.hpp"
#include "tests/lab/extreme_scenes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 160, height = 90;
constexpr double aspect = static_cast<double>(width) / height;

using test::contender;

/// Every method, and every layout of volumes.
std::vector<lab::Contender> everyWay() {
    std::vector<lab::Contender> ways = {
        contender("volumes", [](RenderSettings&) {}),
        contender("all records", [](RenderSettings& of) { of.silhouette = SilhouetteChoice::all; }),
        contender("reference edge",
                  [](RenderSettings& of) { of.multiplicity = MultiplicityMethod::referenceEdge; }),
        contender("three edges",
                  [](RenderSettings& of) { of.multiplicity = MultiplicityMethod::threeEdge; }),
        contender("brute force",
                  [](RenderSettings& of) { of.multiplicity = MultiplicityMethod::triangle; }),
        contender("primitive map",
                  [](RenderSettings& of) { of.shadows = ShadowMethod::primitiveMap; })};
    if (test::canAskPoints())
        ways.push_back(contender(
            "points", [](RenderSettings& of) { of.shadows = ShadowMethod::irregularZBuffer; }));
    return ways;
}

/// `mostWrong`: limit on wrong pixels of a mask, all of them ties.
void expectRight(const LoadedScene& loaded, const Camera& camera, const Light& light,
                 std::size_t mostWrong) {
    lab::CompareTask task;
    task.views = {{"", frustumOf(camera, aspect), light}};
    task.width = width;
    task.height = height;
    task.contenders = everyWay();
    for (const lab::CompareResult& result :
         lab::compareAll(loaded, task, [](double, const std::string&) {})) {
        SCOPED_TRACE(result.name);
        EXPECT_EQ(result.counts.beyond1pxNotTied, 0u);
        EXPECT_LE(result.counts.wrongMaskPixels, mostWrong);
        EXPECT_GT(result.counts.visiblePixels, 1000u);
    }
}

/// As flattened: positions are rounded after placing, lights are not.
LoadedScene placed(const test::SceneBuilder& builder, const glm::dmat4& at) {
    Scene scene = builder.scene();
    for (glm::vec3& position : scene.batches.front().geometry.edit().positions)
        position = glm::vec3(glm::dvec3(at * glm::dvec4(glm::dvec3(position), 1.0)));
    return test::loaded(std::move(scene));
}

glm::dmat4 somePlace(test::Random& random) {
    const glm::dvec3 axis = glm::normalize(random.inCube());
    return glm::rotate(glm::translate(glm::dmat4(1.0), 0.7 * random.inCube()),
                       random.uniform(-0.4, 0.4), axis);
}

/// A ceiling panel, a box, or the tip of a lampshade, over a floor, with the light's place on it.
struct Lamp {
    test::SceneBuilder builder;
    glm::dvec3 light{0.0};
};

Lamp lamp(int kind) {
    Lamp made;
    made.builder.quad({-6, -1.5f, 6}, {6, -1.5f, 6}, {6, -1.5f, -6}, {-6, -1.5f, -6});
    switch (kind) {
    case 0: // on the diagonal of a panel
        made.builder.quad({-0.5f, 0, 0.5f}, {0.5f, 0, 0.5f}, {0.5f, 0, -0.5f}, {-0.5f, 0, -0.5f});
        break;
    case 1: // on a box's edge
        made.builder.box({-0.5f, 0, -0.25f}, {0.25f, 0.5f, 0.25f});
        made.light = {0.25, 0.0, 0.03125};
        break;
    case 2: // at a box's corner
        made.builder.box({0, 0, 0}, {0.5f, 0.375f, 0.25f});
        break;
    case 3: // within a box's face
        made.builder.box({-0.5f, 0, -0.25f}, {0.25f, 0.5f, 0.25f});
        made.light = {-0.0625, 0.0, 0.09375};
        break;
    default: // at the tip of a shade that is open at the bottom
        for (int i = 0; i < 5; ++i) {
            const auto rim = [](int at) {
                const double angle = 1.2566370614359172 * at;
                return glm::vec3(0.4 * std::cos(angle), -0.5, 0.4 * std::sin(angle));
            };
            made.builder.triangle({0, 0, 0}, rim(i + 1), rim(i));
        }
    }
    return made;
}

TEST(LightOnACaster, CastsThroughWhatItLiesOnByEveryMethodAndLayout) {
    test::Random random(4701);
    for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE(i);
        const Lamp of = lamp(i % 5);
        const glm::dmat4 at = somePlace(random);
        const Light light{glm::dvec4(glm::dvec3(at * glm::dvec4(of.light, 1.0)), 1.0)};
        expectRight(placed(of.builder, at), {{2.5, 1, 5}, {0, -0.6, 0}, 50.0}, light, 40);
    }
}

TEST(LightOnACaster, AHairOffIsRight) {
    test::Random random(4702);
    for (int i = 0; i < 5; ++i)
        for (const double hair : {1e-5, -1e-5}) {
            SCOPED_TRACE(i);
            const Lamp of = lamp(i % 5);
            const glm::dmat4 at = somePlace(random);
            const glm::dvec3 place = of.light + glm::dvec3(0.2, 1.0, -0.1) * hair;
            const Light light{glm::dvec4(glm::dvec3(at * glm::dvec4(place, 1.0)), 1.0)};
            const LoadedScene loaded = placed(of.builder, at);
            const Geometry& geometry = *loaded.scene.batches.front().geometry;
            EXPECT_EQ(contactReachOf(geometry.positions, geometry.indices, light.position), 0.0);
            expectRight(loaded, {{2.5, 1, 5}, {0, -0.6, 0}, 50.0}, light, 200);
        }
}

TEST(LightOnACaster, OfTheSharedCases) {
    const std::filesystem::path folder(std::filesystem::path(EDGESHADE_SHARED_SCENES) / ".." /
                                       "cases" / "light-on-a-caster");
    if (!std::filesystem::is_directory(folder))
        GTEST_SKIP() << "there are no shared cases of lights on casters";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path().filename().string());
        LoadedScene loaded = loadScene(entry.path(), std::nullopt);
        loaded.scene.culls = false;
        const std::vector<Light> lights = lightsOf(loaded.scene);
        ASSERT_EQ(lights.size(), 1u);
        expectRight(loaded, {{2.5, 2, 5}, {0, 0, 0}, 45.0}, lights.front(), 40);
    }
}

TEST(SunsInWalls, LeaveThemDarkByEveryMethodAndLayout) {
    test::Random random(4703);
    for (int i = 0; i < 2; ++i) {
        SCOPED_TRACE(i);
        const glm::dmat4 at = somePlace(random);
        // In the planes of two of the box's walls, or of one.
        const glm::dvec3 towards = i % 2 == 0 ? glm::dvec3(0, 1, 0) : glm::dvec3(0.6, 0.8, 0);
        const Light sun{glm::dvec4(glm::dvec3(at * glm::dvec4(towards, 0.0)), 0.0)};
        test::SceneBuilder builder;
        builder.floor(4.0f).box({-1, 0, -1}, {1, 1.5f, 1});
        expectRight(placed(builder, at), {{3.1, 2.2, 4.3}, {0, 0.5, 0}, 50.0}, sun, 40);
    }
}

} // namespace
} // namespace edgeshade
