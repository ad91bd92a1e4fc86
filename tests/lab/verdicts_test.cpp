// Tests the lab's verdict itself: it must find every pixel that the test flips.

#include "src/lab/verdicts.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;

constexpr int size = 200;
constexpr std::size_t pixelCount = std::size_t{size} * size;

/// A lit floor that fills the picture, with pictures that are correct everywhere.
struct Fixture {
    Scene scene = SceneBuilder().floor(50).scene();
    Camera camera{{0, 10, 0}, {0, 0, 0}, 45.0};
    lab::Question question;
    lab::Pictures pictures;

    Fixture() {
        question.scene = &scene;
        question.frustum = frustumOf(camera, 1.0);
        question.lights = {pointLight({1, 8, 2})};
        question.width = question.height = size;
        pictures.mask.assign(4 * pixelCount, 255);
        pictures.unshadowed = [](const lab::LightSet& lights) {
            return std::vector<std::uint8_t>(4 * pixelCount, lights == 0 ? 80 : 200);
        };
        pictures.image.assign(4 * pixelCount, 200);
    }

    lab::AlphaLookup alpha{[](auto&&...) { return 1.0f; }, {}};

    lab::WrongCounts counts() {
        const lab::Oracle oracle(question, alpha);
        auto answers = lab::traceAll(oracle);
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
    test::TestView view{fixture.camera, fixture.question.lights, size, size};
    fixture.pictures.image = test::drawScene(fixture.scene, view, {});
    view.mask = true;
    fixture.pictures.mask = test::drawScene(fixture.scene, view, {});
    view.mask = false;
    RenderSettings plain;
    plain.shadows = ShadowMethod::none;
    const auto lit = test::drawScene(fixture.scene, view, plain);
    fixture.pictures.unshadowed = [lit](const lab::LightSet& lights) {
        return lights == 0 ? std::vector<std::uint8_t>(lit.size(), 80) : lit;
    };
    const lab::WrongCounts counts = fixture.counts();
    EXPECT_EQ(counts.wrongMaskBeyond1px, 0u);
    EXPECT_LE(counts.wrongMaskPixels, 20u);
}

/// Counts for a wrong pixel in the picture's middle. The eye looks straight down from height 10,
/// and 100 pixels reach from the middle to where the floor leaves the picture.
lab::WrongCounts countsOfMiddle(Fixture fixture) {
    const std::size_t middle = pixelCount / 2 + size / 2; // its centre is half a pixel beside (0,
                                                          // 0)
    const std::uint8_t other = fixture.pictures.mask[4 * middle] == 0 ? 255 : 0;
    for (std::size_t c = 0; c < 3; ++c)
        fixture.pictures.mask[4 * middle + c] = other;
    return fixture.counts();
}

/// A floor with a shadow's boundary this many pixels from the centre of the middle pixel.
Fixture boundaryAside(double pixels) {
    Fixture fixture;
    const double pixel = 10.0 * std::tan(glm::radians(22.5)) / (0.5 * size);
    const auto edge = static_cast<float>(pixel * (0.5 + pixels));
    // A roof above the eye, whose edge is projected straight down.
    fixture.scene = SceneBuilder()
                        .floor(50)
                        .quad({edge, 20, -9}, {edge, 20, 9}, {90, 20, 9}, {90, 20, -9})
                        .scene();
    fixture.question.lights = {test::sun({0, 1, 0})};
    const lab::Oracle oracle(fixture.question, fixture.alpha);
    const auto answers = lab::traceAll(oracle);
    for (std::size_t i = 0; i < pixelCount; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            fixture.pictures.mask[4 * i + c] = answers[i].lit != 0 ? 255 : 0;
            fixture.pictures.image[4 * i + c] = answers[i].lit != 0 ? 200 : 80;
        }
    return fixture;
}

TEST(Verdicts, TiesHangOnLessThanAStepOfTheGrid) {
    const auto ties = [](double pixels) {
        const lab::WrongCounts counts = countsOfMiddle(boundaryAside(pixels));
        EXPECT_EQ(counts.wrongMaskPixels, 1u) << pixels;
        return std::pair(counts.tiePixels, counts.deviceTiePixels);
    };
    EXPECT_EQ(ties(0.003), std::pair(std::size_t{1}, std::size_t{1})); // 1/256 is 0.0039
    EXPECT_EQ(ties(0.03), std::pair(std::size_t{1}, std::size_t{0}));
    EXPECT_EQ(ties(0.1), std::pair(std::size_t{0}, std::size_t{0})); // 1/16 is 0.0625
}

TEST(Verdicts, HolesThatAFilterDecidesAreTies) {
    const auto tiesWith = [](float least, float most) {
        Material leaf;
        leaf.alphaMode = AlphaMode::mask;
        Fixture fixture;
        fixture.scene = SceneBuilder()
                            .floor(50)
                            .material(leaf)
                            .quad({-1, 1, -2}, {-1, 1, 1}, {3, 1, 1}, {3, 1, -2})
                            .scene();
        fixture.alpha.range = [=](auto&&...) { return glm::vec2(least, most); };
        const lab::WrongCounts counts = countsOfMiddle(fixture);
        EXPECT_EQ(counts.wrongMaskPixels, 1u);
        EXPECT_EQ(counts.tiePixels, counts.deviceTiePixels);
        return counts.tiePixels;
    };
    EXPECT_EQ(tiesWith(0.4f, 0.9f), 1u); // the cutoff is 0.5
    EXPECT_EQ(tiesWith(0.6f, 0.9f), 0u);
    EXPECT_EQ(tiesWith(0.1f, 0.4f), 0u);
}

} // namespace
} // namespace edgeshade
