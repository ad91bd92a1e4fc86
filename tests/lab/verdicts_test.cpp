// The lab's verdict is itself tested: what is flipped by hand must be found, all of it.

#include "src/lab/verdicts.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;

constexpr int size = 200;
constexpr std::size_t pixelCount = std::size_t{size} * size;

/// A lit floor that fills the picture, with pictures that are right everywhere.
struct Fixture {
    Scene scene = SceneBuilder().floor(50).scene();
    lab::Question question;
    lab::Pictures pictures;

    Fixture() {
        question.scene = &scene;
        question.camera = {{0, 10, 0}, {0, 0, 0}, 45.0};
        question.lights = {pointLight({1, 8, 2})};
        question.width = question.height = size;
        pictures.mask.assign(4 * pixelCount, 255);
        pictures.ambient.assign(4 * pixelCount, 80);
        pictures.unshadowed = {std::vector<std::uint8_t>(4 * pixelCount, 200)};
        pictures.image.assign(4 * pixelCount, 200);
    }

    lab::WrongCounts counts() {
        const lab::Oracle oracle(question, [](auto&&...) { return 1.0f; });
        auto answers = lab::traceAll(oracle, {});
        return lab::compareWithOracle(oracle, answers, pictures, 8).counts;
    }
};

TEST(Verdicts, NothingIsWrongWhereAllIsRight) {
    const lab::WrongCounts counts = Fixture().counts();
    EXPECT_EQ(counts.pixels, pixelCount);
    EXPECT_EQ(counts.visiblePixels, pixelCount);
    EXPECT_EQ(counts.wrongMaskPixels, 0u);
    EXPECT_EQ(counts.wrongImagePixels, 0u);
    EXPECT_EQ(counts.tiePixels, 0u);
}

TEST(Verdicts, AHundredFlippedPixelsAreExactlyAHundred) {
    Fixture fixture;
    for (std::size_t k = 0; k < 100; ++k) {
        const std::size_t pixel = 37 + 391 * k;
        for (std::size_t c = 0; c < 3; ++c)
            fixture.pictures.mask[4 * pixel + c] = 0;
        for (std::size_t c = 0; c < 3; ++c)
            fixture.pictures.image[4 * pixel + c] = 80;
    }
    const lab::WrongCounts counts = fixture.counts();
    EXPECT_EQ(counts.wrongMaskPixels, 100u);
    EXPECT_EQ(counts.wrongMaskBeyond1px, 100u);
    EXPECT_EQ(counts.wrongImagePixels, 100u);
    EXPECT_EQ(counts.wrongImageBeyond1px, 100u);
    EXPECT_EQ(counts.tiePixels, 0u);
    EXPECT_EQ(counts.beyond1pxNotTied, 100u);
}

TEST(Verdicts, ColoursMayDifferByTwo) {
    Fixture fixture;
    fixture.pictures.image[400] = 202;
    fixture.pictures.image[800] = 203;
    EXPECT_EQ(fixture.counts().wrongImagePixels, 1u);
}

TEST(Verdicts, AMissingSurfaceIsWrongInTheMask) {
    Fixture fixture;
    fixture.pictures.mask[4 * 77 + 3] = 0;
    EXPECT_EQ(fixture.counts().wrongMaskPixels, 1u);
}

TEST(Verdicts, WhatTheProgramDrawsIsRight) {
    Fixture fixture;
    fixture.scene = SceneBuilder().floor(50).box({-1, 1, -1}, {1, 2, 1}).scene();
    test::TestView view{fixture.question.camera, fixture.question.lights, size, size};
    fixture.pictures.image = test::drawScene(fixture.scene, view, {});
    view.mask = true;
    fixture.pictures.mask = test::drawScene(fixture.scene, view, {});
    view.mask = false;
    RenderSettings plain;
    plain.shadows = ShadowMethod::none;
    fixture.pictures.unshadowed = {test::drawScene(fixture.scene, view, plain)};
    const lab::WrongCounts counts = fixture.counts();
    EXPECT_EQ(counts.wrongMaskBeyond1px, 0u);
    EXPECT_LE(counts.wrongMaskPixels, 20u);
}

} // namespace
} // namespace edgeshade
