// Reflections of a loaded environment against brute force.
#include "src/environment/reading.hpp"
#include "src/environment/specular_lobe.hpp"
#include "tests/environment/sky.hpp"
#include "tests/support/environment_lookup.hpp"
#include "tests/support/hdr_writing.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade::test {
namespace {

Environment environmentOf(const Sky& sky) {
    const Bytes file =
        panoramaOf(512, 256, [&](const glm::vec3& d) { return glm::vec3(sky(glm::dvec3(d))); });
    return readEnvironment(file, "'a.hdr'", EnvironmentScale::asStored);
}

/// The largest error, as a share of the largest radiance expected at that roughness.
float worstError(const Environment& environment, const Sky& sky, float roughness) {
    float worst = 0.0f, brightest = 0.0f;
    for (glm::vec3 direction : testDirections()) {
        const glm::vec3 expected(
            roughness == 0.0f
                ? sky(glm::dvec3(direction))
                : ggxByBruteForce(sky, glm::dvec3(direction), static_cast<double>(roughness)));
        const glm::vec3 error =
            glm::abs(test::environmentSpecular(environment, direction, roughness) - expected);
        worst = std::max({worst, error.r, error.g, error.b});
        brightest = std::max({brightest, expected.r, expected.g, expected.b});
    }
    return worst / brightest;
}

} // namespace

TEST(Filtering, ReflectionsAreCloseToBruteForceAtEveryRoughness) {
    const Environment environment = environmentOf(lopsidedSky);
    for (int level = 0; level < Atlas::levels(); ++level) {
        const float roughness = Atlas::roughness(level);
        const float error = worstError(environment, lopsidedSky, roughness);
        RecordProperty("level" + std::to_string(level), std::to_string(error));
        EXPECT_LT(error, 0.03f) << roughness;
    }
}

TEST(Filtering, BetweenLevelsTheyAreCloseToo) {
    const Environment environment = environmentOf(lopsidedSky);
    for (int level = 0; level + 1 < Atlas::levels(); ++level) {
        const float roughness = 0.5f * (Atlas::roughness(level) + Atlas::roughness(level + 1));
        const float error = worstError(environment, lopsidedSky, roughness);
        RecordProperty("above" + std::to_string(level), std::to_string(error));
        EXPECT_LT(error, 0.07f) << roughness;
    }
}

TEST(Filtering, AConstantSkyIsTheSameEverywhere) {
    const Environment environment = environmentOf([](const glm::dvec3&) { return glm::dvec3(1); });
    for (const glm::vec3& direction : testDirections()) {
        const glm::vec3 diffuse = test::environmentDiffuse(environment, direction);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(diffuse[channel], 1.0f, 1e-4f);
        for (const float roughness : {0.0f, 0.05f, 0.3f, 0.5f, 0.77f, 1.0f}) {
            const glm::vec3 specular = test::environmentSpecular(environment, direction, roughness);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(specular[channel], 1.0f, 0.01f) << roughness;
        }
    }
}

TEST(Filtering, RoughnessBeyondItsRangeCountsAsItsEnds) {
    const Environment environment = environmentOf(lopsidedSky);
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    EXPECT_EQ(test::environmentSpecular(environment, up, -1.0f),
              test::environmentSpecular(environment, up, 0.0f));
    EXPECT_EQ(test::environmentSpecular(environment, up, 2.0f),
              test::environmentSpecular(environment, up, 1.0f));
}

TEST(SpecularLobe, SamplesStandForTheLobe) {
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        const SpecularLobe lobe(roughness, 64);
        float weights = 0.0f;
        for (const SpecularLobe::Sample& sample : lobe.samples()) {
            EXPECT_GT(sample.direction.z, 0.0f);
            EXPECT_NEAR(glm::length(sample.direction), 1.0f, 1e-5f);
            weights += sample.weight;
        }
        EXPECT_NEAR(weights, 1.0f, 1e-5f);
    }
    // At roughness 1 the density is uniform: together the samples represent the hemisphere.
    const SpecularLobe even(1.0f, 64);
    for (const SpecularLobe::Sample& sample : even.samples())
        EXPECT_NEAR(sample.solidAngle, 2.0f * std::numbers::pi_v<float> / 64.0f, 1e-4f);
}

TEST(SpecularLobe, FramesTurnTheLobeAndDoNotStretchIt) {
    const SpecularLobe lobe(0.5f, 256);
    for (const glm::vec3& around : testDirections()) {
        const glm::vec3 mean =
            lobe.filter(around, [](const glm::vec3& direction, float) { return direction; });
        EXPECT_GT(glm::dot(glm::normalize(mean), around), 0.9999f);
        EXPECT_NEAR(lobe.filter(around, [](const glm::vec3& d, float) { return d * d; }).x +
                        lobe.filter(around, [](const glm::vec3& d, float) { return d * d; }).y +
                        lobe.filter(around, [](const glm::vec3& d, float) { return d * d; }).z,
                    1.0f, 1e-4f);
    }
}

} // namespace edgeshade::test
