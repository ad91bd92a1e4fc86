// 64 lights, all with shadows, against the oracle; and the error when some shadows are left out.
#include "src/lab/compare.hpp"

#include "src/bench/scattered_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

lab::CompareTask taskOf(const Scene& scene, std::size_t lights) {
    lab::CompareTask task;
    task.width = 120;
    task.height = 80;
    task.lights = bench::scatterLights(scene, lights);
    const double aspect = static_cast<double>(task.width) / task.height;
    for (const Camera& camera :
         {Camera{{1, 6, 10}, {0, 0, 0}, 45.0}, Camera{{-4, 1, 3}, {2, 0.5, -1}, 70.0}})
        task.views.push_back({"a view", frustumOf(camera, aspect), task.lights.front()});
    return task;
}

lab::Contender contender(std::optional<std::size_t> shadowed) {
    lab::Contender of;
    of.name = "volumes";
    of.settings.shading = Shading::full;
    of.settings.shadowedLights = shadowed;
    return of;
}

TEST(ManyLights, SixtyFourAreAsTheOracleSays) {
    const Scene scene = test::yard().scene();
    const LoadedScene loaded{{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
    lab::CompareTask task = taskOf(scene, 64);
    task.contenders = {contender({}), contender(64), contender(16), contender(0)};
    const auto results = lab::compareAll(loaded, task, [](double, const std::string&) {});
    const auto& all = results[0].counts;
    EXPECT_GT(all.visiblePixels, 9'000u);
    EXPECT_LE(all.wrongImageBeyond1px, 2u);
    EXPECT_LE(all.wrongImagePixels, all.visiblePixels / 1000);
    EXPECT_EQ(results[1].counts.wrongImagePixels, all.wrongImagePixels);
    EXPECT_GT(results[2].counts.wrongImagePixels, 10 * all.wrongImagePixels + 100);
    EXPECT_GT(results[3].counts.wrongImagePixels, results[2].counts.wrongImagePixels);
}

TEST(ManyLights, MoreThanAWordHasBitsAreToldApart) {
    const Scene scene = SceneBuilder().floor(5).box({-1, 1, -1}, {1, 2, 1}).scene();
    lab::Question question;
    question.scene = &scene;
    question.frustum = frustumOf(Camera{{0, 8, 0.1}, {0, 0, 0}, 60.0}, 1.0);
    question.width = question.height = 40;
    for (int i = 0; i < 200; ++i) // alternately under the box and far above it
        question.lights.push_back(test::pointLight({0, i % 3 == 0 ? 0.5 : 9.0, 0}));
    const lab::Oracle oracle(question, {});
    const lab::Answer beneath = oracle.at(20.0, 36.0); // on the floor beside the box
    ASSERT_TRUE(beneath.surface);
    lab::LightSet expected;
    for (std::size_t i = 0; i < 200; ++i) {
        EXPECT_EQ(oracle.at(20.0, 20.0).lit.has(i), i % 3 != 0) << "the box's top, " << i;
        expected.add(i);
    }
    EXPECT_TRUE(beneath.lit == expected);
    EXPECT_FALSE(beneath.lit == lab::LightSet(~std::uint64_t{0}));
}

} // namespace
} // namespace edgeshade
