// Masks for cameras with any position, roll and window, against ray casting in double.

#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Case;
using test::expectRight;
using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::yard;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const glm::dmat4 rolled = glm::rotate(glm::dmat4(1.0), 0.5, {0, 0, 1}) * viewFromWorld(corner);

/// A window beside the viewing direction, rolled by 29 degrees.
const Frustum offAxis = frustumOf(rolled, glm::frustum(-0.06, 0.02, -0.04, 0.02, 0.1, 10.0));

Frustum parallel(const Camera& camera, double height) {
    return frustumOf(camera, static_cast<double>(test::maskWidth) / test::maskHeight, height);
}
// Neither exactly along walls, nor with edges through pixel centres.
const Frustum fromAbove = parallel({{0.013, 8, 0.007}, {0.3, 0, 0.2}}, 8.1);
const Frustum aslant = parallel(corner, 7.0);
const Frustum fromTheSide = parallel({{6, 1.0, 0.2}, {0, 1.0, 0}}, 6.0);

Case seenBy(const Frustum& frustum, const Light& light) {
    return {.scene = yard().scene(), .camera = {}, .light = light, .frustum = frustum};
}

class OffAxis : public testing::TestWithParam<Light> {};
TEST_P(OffAxis, AgreesWithRays) {
    expectRight(seenBy(offAxis, GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Projections, OffAxis,
                         testing::Values(pointLight({0.3, 4, 0.7}), pointLight({-0.4, 1.1, 0.9}),
                                         sun({0.5, 1, -0.3})));

TEST(Projections, OffAxisWithSlices) {
    Case test = seenBy(offAxis, pointLight({-0.4, 1.1, 0.9}));
    test.slices = 4;
    expectRight(test);
}

TEST(Projections, OffAxisEyeInAShadow) {
    Case test = seenBy(frustumOf(glm::rotate(glm::dmat4(1.0), -0.8, {0, 0, 1}) *
                                     viewFromWorld({{-1.5, 0.2, -0.5}, {1, 0.3, 1}}),
                                 glm::frustum(-0.03, 0.09, -0.05, 0.06, 0.1, 10.0)),
                       pointLight({-1.4, 5, -0.4}));
    expectRight(test);
}

TEST(Projections, OffAxisLightWithARange) {
    Case test = seenBy(offAxis, Light{{0.2, 2.5, 1.2, 1.0}, 3.3});
    expectRight(test);
}

/// Directional lights that shine into the picture, along it, and out of it.
class Parallel : public testing::TestWithParam<std::tuple<Frustum, Light>> {};
TEST_P(Parallel, AgreesWithRays) {
    const auto& [frustum, light] = GetParam();
    expectRight(seenBy(frustum, light), MultiplicityMethod::plane);
}
INSTANTIATE_TEST_SUITE_P(Projections, Parallel,
                         testing::Combine(testing::Values(fromAbove, aslant, fromTheSide),
                                          testing::Values(sun({0.5, 1, -0.3}), sun({-1, 0.4, -1}),
                                                          sun({-0.3, 0.2, 1}),
                                                          pointLight({0.3, 6, 0.7}))));

TEST(Projections, ParallelSunAcrossThePicture) {
    expectRight(seenBy(fromTheSide, sun({-0.01, 1, 0.3})), MultiplicityMethod::plane);
}

TEST(Projections, ParallelFromBelowTheGround) {
    // The sun shines towards the viewer.
    Case test = seenBy(parallel({{1, -6, 2}, {0, 0, 0}}, 9.0), sun({0.5, 1, -0.3}));
    test.scene = SceneBuilder()
                     .box({-2, 0.5f, -1}, {-1, 2, 0})
                     .box({0.5f, 1.25f, 0.5f}, {1.5f, 2, 2})
                     .box({-2.5f, 3.0f, -2}, {1.0f, 3.2f, 1})
                     .scene();
    expectRight(test, MultiplicityMethod::plane);
}

TEST(Projections, ParallelShowsWhatIsBehindTheCameraToo) {
    // The camera is inside the scene; its place along its direction makes no difference.
    expectRight(seenBy(parallel({{0.5, 0.7, 0.3}, {-4.5, -2.8, -5.4}}, 7.0), sun({0.5, 1, -0.3})),
                MultiplicityMethod::plane);
}

TEST(Projections, ParallelLightWithARange) {
    expectRight(seenBy(fromAbove, Light{{0.3, 3.0, 0.7, 1.0}, 3.4}), MultiplicityMethod::plane);
}

// Lamps at the casters' depths, where these are cut: above, between and below them as seen.
TEST(Projections, ParallelLightAmongTheCasters) {
    for (const Light& light :
         {pointLight({-0.4, 1.1, 0.9}), pointLight({0.9, 1.7, -0.8}), pointLight({0.2, 0.4, 1.3})})
        for (const Frustum& frustum : {fromAbove, aslant, fromTheSide})
            expectRight(seenBy(frustum, light), MultiplicityMethod::plane);
}

TEST(Projections, ParallelLightWithinABox) {
    Case test = seenBy(aslant, pointLight({0.1, 1.1, -0.1}));
    test.scene = SceneBuilder()
                     .floor(5)
                     .quad({-1, 0.2f, -1}, {-1, 2, -1}, {1, 2, -1}, {1, 0.2f, -1})
                     .quad({-1, 0.2f, 1}, {-0.2f, 0.2f, 1}, {-0.2f, 2, 1}, {-1, 2, 1})
                     .quad({1, 0.2f, -1}, {1, 2, -1}, {1, 2, 0.6f}, {1, 0.2f, 0.6f})
                     .box({-2, 0.5f, -1}, {-1.5f, 2, 0})
                     .scene();
    expectRight(test, MultiplicityMethod::plane);
}

TEST(Projections, ParallelAtAnyScale) {
    for (const double scale : {1e-6, 1e6})
        for (const Light& light :
             {sun({0.5, 1, -0.3}), pointLight(scale * glm::dvec3(-0.4, 1.1, 0.9))}) {
            Case test =
                seenBy(parallel({scale * corner.from, scale * corner.to}, 7.0 * scale), light);
            test.scene = yard().placedBy(glm::scale(glm::dmat4(1.0), glm::dvec3(scale))).scene();
            expectRight(test, MultiplicityMethod::plane);
        }
}

// Alpha-tested casters with holes to see through, turned away from the viewer and towards it.
TEST(Projections, ParallelCastersWithHoles) {
    Material leaf;
    leaf.alphaMode = AlphaMode::mask;
    leaf.alphaCutoff = 0.5f;
    leaf.baseColorFactor.a = 0.2f; // all hole
    for (const Light& light : {sun({0.5, 1, -0.3}), sun({-0.3, 0.2, 1}), pointLight({0.3, 6, 0.7}),
                               pointLight({-0.4, 1.6, 0.9})})
        for (const Frustum& frustum : {fromAbove, aslant, parallel({{1, -6, 2}, {0, 0, 0}}, 9.0)}) {
            Case test = seenBy(frustum, light);
            test.scene = SceneBuilder()
                             .floor(5)
                             .box({-2, 0.5f, -1}, {-1, 2, 0})
                             .material(leaf)
                             .quad({-1, 1.2f, 1}, {1, 1.0f, 1}, {1, 1.4f, -1}, {-1, 1.3f, -1})
                             .box({1.2f, 0.4f, -1}, {2, 1.1f, 0.3f})
                             .scene();
            test.castMasked = true;
            expectRight(test, MultiplicityMethod::plane);
        }
}

TEST(Projections, ParallelFarFromTheOrigin) {
    const glm::dvec3 away(1e6, 3e5, -2e6);
    Case test = seenBy(parallel({corner.from + away, corner.to + away}, 7.0), sun({0.5, 1, -0.3}));
    test.scene = yard().placedBy(glm::translate(glm::dmat4(1.0), away)).scene();
    expectRight(test, MultiplicityMethod::plane);
}

} // namespace
} // namespace edgeshade
