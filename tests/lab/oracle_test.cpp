#include "src/lab/exact_judge.hpp"
#include "src/lab/oracle.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using lab::Answer;
using lab::Oracle;
using test::pointLight;
using test::SceneBuilder;

const lab::AlphaLookup solid{[](const rays::SurfaceTriangle&, double, double) { return 1.0f; }, {}};

lab::Question above(const Scene& scene, double half, int size, const Light& light) {
    lab::Question question;
    question.scene = &scene;
    question.frustum =
        frustumOf({{0, 20, 0}, {0, 0, 0}, glm::degrees(2.0 * std::atan(half / 20.0))}, 1.0);
    question.lights = {light};
    question.width = question.height = size;
    return question;
}

// The light at height 8 projects the box's top, at height 4 and 1 wide, onto the floor with factor
// 2; the eye at height 20 sees the top itself up to 1.25.
TEST(Oracle, KnowsTheShadowOfABox) {
    const Scene scene = SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1}).scene();
    const Oracle oracle(above(scene, 5.0, 100, pointLight({0, 8, 0})), solid);
    const auto at = [&](double x) { return oracle.at(50.0 + 10.0 * x, 50.0); };
    EXPECT_EQ(at(1.2), (Answer{true, 1})); // the box's top
    EXPECT_EQ(at(1.3), (Answer{true, 0}));
    EXPECT_EQ(at(1.99), (Answer{true, 0}));
    EXPECT_EQ(at(2.01), (Answer{true, 1}));
    EXPECT_EQ(at(-1.99), (Answer{true, 0}));
    EXPECT_EQ(at(-2.01), (Answer{true, 1}));
}

TEST(Oracle, SeesNothingWhereNothingIs) {
    const Scene scene = SceneBuilder().floor(1).scene();
    const Oracle oracle(above(scene, 5.0, 100, pointLight({0, 8, 0})), solid);
    EXPECT_EQ(oracle.at(2.0, 2.0), Answer());
}

TEST(Oracle, ASheetTurnedAwayFromTheLightIsNotLit) {
    const Scene scene = SceneBuilder().floor(3).scene();
    const Oracle oracle(above(scene, 2.0, 100, pointLight({0.5, -8, 0})), solid);
    EXPECT_EQ(oracle.at(50.0, 50.0), (Answer{true, 0}));
}

TEST(Oracle, CoincidentSheetsDoNotShadeEachOther) {
    const Scene scene = SceneBuilder().floor(3).floor(4).scene();
    const Oracle oracle(above(scene, 2.0, 100, pointLight({0.5, 8, 0.1})), solid);
    EXPECT_EQ(oracle.at(50.3, 50.7), (Answer{true, 1}));
    EXPECT_TRUE(lab::judgeExactly(oracle, 50.3, 50.7).coincident);
}

TEST(Oracle, WhatASceneCullsIsNotSeenAndBlocks) {
    // A lid that shows the eye its back hides nothing, but shades the floor under it.
    const SceneBuilder builder =
        SceneBuilder().floor(4).quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1});
    for (const bool mirrored : {false, true}) {
        SceneBuilder placed = builder;
        if (mirrored) placed.placedBy(glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)));
        Scene scene = placed.scene();
        for (const bool culls : {false, true}) {
            scene.culls = culls;
            const Oracle oracle(above(scene, 5.0, 100, pointLight({0.1, 8, 0.2})), solid);
            for (const auto& [x, answer] : {std::pair(50.2, Answer{true, culls ? 0u : 1u}),
                                            std::pair(80.2, Answer{true, 1})}) {
                EXPECT_EQ(oracle.at(x, 50.3), answer);
                EXPECT_EQ(lab::judgeExactly(oracle, x, 50.3).answer, answer);
            }
            EXPECT_EQ(oracle.surfacesAt(50.2, 50.3).size(), culls ? 1u : 2u);
        }
    }
}

TEST(Oracle, EveryLightHasItsBit) {
    const Scene scene = SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1}).scene();
    lab::Question question = above(scene, 5.0, 100, pointLight({0, 8, 0}));
    question.lights.push_back(pointLight({4, 3, 0}));
    const Oracle oracle(question, solid);
    EXPECT_EQ(oracle.at(65.0, 50.0).lit, 2u); // x = 1.5: only in the first light's shadow
}

TEST(Oracle, KnowsHowFarALightReaches) {
    // From height 4 a range of 5 reaches 3 on the floor.
    const Scene scene = SceneBuilder().floor(6).scene();
    Light light = pointLight({0, 4, 0});
    light.range = 5.0;
    const Oracle oracle(above(scene, 5.0, 100, light), solid);
    for (const double x : {-3.01, -2.99, 0.0, 2.99, 3.01, 4.5}) {
        const Answer expected{true, std::abs(x) < 3.0 ? 1u : 0u};
        EXPECT_EQ(oracle.at(50.0 + 10.0 * x, 50.0), expected) << x;
        EXPECT_EQ(lab::judgeExactly(oracle, 50.0 + 10.0 * x, 50.0).answer, expected) << x;
    }
    light.position.w = 0.0;
    EXPECT_EQ(Oracle(above(scene, 5.0, 100, light), solid).at(95.0, 50.0).lit, 1u);
}

TEST(Oracle, AgreesWithBruteForceAndWithItsExactJudge) {
    const Scene scene = SceneBuilder()
                            .floor(5)
                            .box({-2, 0.5f, -1}, {-1, 2, 0})
                            .box({0.5f, 0.25f, 0.5f}, {1.5f, 1, 2})
                            .triangle({2, 0.1f, -2}, {3, 0.1f, -2}, {2.5f, 2.5f, -1.5f})
                            .scene();
    lab::Question question;
    question.scene = &scene;
    question.frustum = frustumOf({{5, 4, 6}, {0, 0.5, 0}, 50.0}, 4.0 / 3.0);
    question.lights = {pointLight({0.3, 4, 0.7})};
    question.width = 120;
    question.height = 90;
    const Oracle oracle(question, solid);
    const auto answers = lab::traceAll(oracle);
    const auto expected = test::castMask(scene, question.frustum, question.lights[0], 120, 90, 0.0);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Answer wanted{expected[i] != test::Answer::nothing,
                            expected[i] == test::Answer::lit ? 1u : 0u};
        ASSERT_EQ(answers[i], wanted) << "pixel " << i;
        const lab::Verdict verdict = lab::judgeExactly(oracle, static_cast<double>(i % 120) + 0.5,
                                                       static_cast<double>(i / 120) + 0.5);
        ASSERT_EQ(verdict.answer, wanted) << "pixel " << i;
    }
}

// The bound on rounding must hold in the hardest cases: lights in planes and on edges, far from the
// origin, rays through vertices and along edges.
TEST(Oracle, WhatItCallsCertainIsExactlyTrue) {
    std::size_t certain = 0, all = 0;
    for (const Light& light : {pointLight({0.3, 4, 0.7}), pointLight({1.5, 1, 2}),
                               pointLight({4, 1, 3}), test::sun({1, 0, 0.3})}) {
        for (const double away : {0.0, 1e6}) {
            const glm::dvec3 offset(away, 0.5 * away, -away);
            const Scene scene =
                test::yard().placedBy(glm::translate(glm::dmat4(1.0), offset)).scene();
            lab::Question question;
            question.scene = &scene;
            question.frustum = frustumOf(
                {glm::dvec3(5, 1, 4) + offset, glm::dvec3(0, 1, 1) + offset, 60.0}, 4.0 / 3.0);
            question.lights = {{light.position + glm::dvec4(offset * light.position.w, 0.0)}};
            question.width = 32;
            question.height = 24;
            const Oracle oracle(question, solid);
            for (int i = 0; i < 32 * 24; ++i) {
                // Pixel centres, and grid points between them.
                const double x = i % 32 + 0.5 * (i % 2), y = i / 32 + 0.5 * (i % 3 == 0);
                const Oracle::Checked checked = oracle.checkedAt(x, y);
                ++all;
                if (!checked.certain) continue;
                ++certain;
                ASSERT_EQ(checked.answer, lab::judgeExactly(oracle, x, y).answer)
                    << "at " << x << ", " << y;
            }
        }
    }
    EXPECT_GT(certain, all / 2);
}

} // namespace
} // namespace edgeshade
