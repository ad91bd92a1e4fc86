#include "src/environment/neutral.hpp"

#include "tests/environment/sky.hpp"
#include "tests/support/environment_lookup.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

glm::dvec3 neutralSky(const glm::dvec3& direction) {
    return glm::dvec3(static_cast<double>(neutralRadiance(static_cast<float>(direction.y))));
}

} // namespace

TEST(NeutralEnvironment, TheMeanOverAllDirectionsIsOne) {
    EXPECT_NEAR(meanOf(neutralSky).g, 1.0, 1e-3);
    EXPECT_NEAR(neutralEnvironment().diffuse[0].g, 1.0f, 1e-3f);
}

TEST(NeutralEnvironment, ItIsGreyAndBrighterAboveThanBelow) {
    const Environment environment = neutralEnvironment();
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    const glm::vec3 above = test::environmentDiffuse(environment, up);
    EXPECT_GT(above.g, 1.3f);
    EXPECT_LT(test::environmentDiffuse(environment, -up).g, 0.7f);
    EXPECT_EQ(above.r, above.b);
    EXPECT_GT(neutralRadiance(0.05f), neutralRadiance(0.5f)); // the horizon's band
    EXPECT_GT(neutralRadiance(1.0f), 2.0f * neutralRadiance(0.5f));
}

TEST(NeutralEnvironment, DiffuseIsCloseToBruteForce) {
    const Environment environment = neutralEnvironment();
    for (const glm::vec3& normal : testDirections())
        EXPECT_NEAR(test::environmentDiffuse(environment, normal).g,
                    lambertByBruteForce(neutralSky, glm::dvec3(normal)).g, 0.04);
}

TEST(NeutralEnvironment, ReflectionsAreCloseToBruteForce) {
    const Environment environment = neutralEnvironment();
    for (int level = 0; level < Atlas::levels(); ++level) {
        const float roughness = Atlas::roughness(level);
        double worst = 0.0;
        for (const glm::vec3& direction : testDirections()) {
            const glm::dvec3 d(direction);
            const double expected =
                level == 0 ? neutralSky(d).g
                           : ggxByBruteForce(neutralSky, d, static_cast<double>(roughness)).g;
            const float actual = test::environmentSpecular(environment, direction, roughness).g;
            worst = std::max(worst, std::abs(static_cast<double>(actual) - expected));
        }
        RecordProperty("level" + std::to_string(level), std::to_string(worst));
        EXPECT_LT(worst, 0.03) << roughness;
    }
}

TEST(NeutralEnvironment, ItIsTheSameEveryTime) {
    EXPECT_EQ(neutralEnvironment().specular.rgba(), neutralEnvironment().specular.rgba());
}

} // namespace edgeshade::test
