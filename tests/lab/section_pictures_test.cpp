// Scenes that sections cut open, judged by an oracle that clips its own triangles (docs/method.md,
// C49 and C50).
#include "src/scene/cut_loaded.hpp"
#include "tests/lab/contender.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 160, height = 100;

using test::contender;

std::vector<lab::Contender> everyWay() {
    std::vector<lab::Contender> ways = {
        contender("volumes", [](RenderSettings&) {}),
        contender("published",
                  [](RenderSettings& of) { of.multiplicity = MultiplicityMethod::referenceEdge; }),
        contender("brute force",
                  [](RenderSettings& of) { of.multiplicity = MultiplicityMethod::triangle; }),
        contender("primitive map",
                  [](RenderSettings& of) { of.shadows = ShadowMethod::primitiveMap; })};
    if (test::canAskPoints())
        ways.push_back(contender(
            "points", [](RenderSettings& of) { of.shadows = ShadowMethod::irregularZBuffer; }));
    return ways;
}

/// A house of solid walls and a roof, on a floor, with a table and a tent that is no solid.
test::SceneBuilder house() {
    test::SceneBuilder builder;
    builder.floor(6, -0.01f);
    builder.box({-2, 0, -2}, {-1.8f, 2, 2}).box({1.8f, 0, -2}, {2, 2, 2});
    builder.box({-1.8f, 0, -2}, {1.8f, 2, -1.8f}).box({-1.8f, 0, 1.8f}, {-0.4f, 2, 2});
    builder.box({0.4f, 0, 1.8f}, {1.8f, 2, 2}).box({-2.3f, 2, -2.3f}, {2.3f, 2.2f, 2.3f});
    builder.box({-0.6f, 0.7f, -0.5f}, {0.7f, 0.8f, 0.4f}).box({0, 0, -0.1f}, {0.1f, 0.7f, 0.1f});
    builder.quad({-1.5f, 0, 1}, {-0.5f, 0, 1}, {-0.5f, 1, 0.5f}, {-1.5f, 1, 0.5f});
    builder.triangle({-1.5f, 0, 0}, {-1, 1.5f, 0}, {-0.5f, 0, 0.2f});
    return builder;
}

struct SectionCase {
    std::string name;
    std::vector<glm::dvec4> planes;
    Light light;
};

std::vector<SectionCase> cases() {
    const Light sun = test::sun({0.4, 1.0, 0.3}), low = test::sun({-1.0, 0.2, 0.5});
    const Light lamp = test::pointLight({0.3, 1.4, 0.2}), above = test::pointLight({0.5, 2.6, 0});
    const glm::dvec4 roof(0, -1, 0, 1.5), half(-1, 0, 0, 0.3), askew(-0.5, -0.6, 0.2, 1.0);
    return {{"roof off, sun", {roof}, sun},
            {"roof off, low sun", {roof}, low},
            {"roof off, lamp inside", {roof}, lamp},
            {"roof off, lamp in the part cut away", {roof}, above},
            {"half, lamp", {half}, lamp},
            {"half, sun", {half}, sun},
            {"askew, sun", {askew}, sun},
            {"two planes, lamp", {roof, half}, lamp},
            {"box, sun",
             {{1, 0, 0, 1.2},
              {-1, 0, 0, 1.2},
              {0, 1, 0, -0.2},
              {0, -1, 0, 1.6},
              {0, 0, 1, 2.5},
              {0, 0, -1, 1.0}},
             sun},
            {"a wall's face", {{0, -1, 0, 2}}, sun},
            {"a wall's face, from the other side", {{0, 1, 0, -2}}, sun},
            {"edges and vertices", {{1, 1, 0, 0}}, lamp},
            {"through the lamp", {{0, -1, 0, 1.4}}, lamp},
            {"through the eye", {{0, -7, 5, 0}}, sun}};
}

TEST(SectionPictures, AreRightByEveryMethod) {
    for (const SectionCase& of : cases())
        for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
            SCOPED_TRACE(of.name + (shadows == SectionShadows::cut ? ", cut" : ", whole"));
            LoadedScene loaded = test::loadedOf(house().scene());
            // Dragged there, so that records are made in the memory of others.
            for (const double before : {0.4, 0.2, -0.1, 0.0}) {
                std::vector<glm::dvec4> planes = of.planes;
                planes.front().w += before;
                cutScene(loaded, {planes, shadows, glm::vec3(0.6f, 0.1f, 0.05f)});
            }
            lab::CompareTask task;
            task.views = {{"",
                           frustumOf(Camera{{3.1, 5.0, 7.0}, {0.0, 0.6, 0.0}, 45.0},
                                     static_cast<double>(width) / height),
                           of.light}};
            task.width = width;
            task.height = height;
            task.contenders = everyWay();
            for (const lab::CompareResult& result :
                 lab::compareAll(loaded, task, [](double, const std::string&) {})) {
                SCOPED_TRACE(result.name);
                EXPECT_EQ(result.counts.beyond1pxNotTied, 0u);
                EXPECT_LE(result.counts.wrongMaskPixels, 25u);
                EXPECT_GT(result.counts.visiblePixels, 700u);
            }
        }
}

TEST(SectionPictures, OfNothingLeftShowNothingAndWarn) {
    LoadedScene loaded = test::loadedOf(house().scene());
    cutScene(loaded, {{{0, 1, 0, -100}}, SectionShadows::cut, {}});
    ASSERT_FALSE(loaded.scene.warnings.sentences().empty());
    EXPECT_NE(loaded.scene.warnings.sentences().back().find("leaves nothing"), std::string::npos);
}

TEST(SectionPictures, TakenAwayLeaveTheSceneAsItWas) {
    LoadedScene loaded = test::loadedOf(house().scene());
    const auto before = loaded.planePairs;
    const Geometry* const geometry = &*loaded.scene.batches.front().geometry;
    cutScene(loaded, {{{0, -1, 0, 1.5}}, SectionShadows::whole, {}});
    cutScene(loaded, {{{-1, 0, 0, 0}}, SectionShadows::cut, {}});
    EXPECT_NE(loaded.planePairs, before);
    cutScene(loaded, {});
    EXPECT_EQ(loaded.planePairs, before);
    EXPECT_EQ(&*loaded.scene.batches.front().geometry, geometry);
    EXPECT_FALSE(loaded.scene.cutFrom || loaded.uncut);
}

} // namespace
} // namespace edgeshade
