#include "src/environment/diffuse_sum.hpp"

#include "tests/environment/sky.hpp"
#include "tests/support/environment_lookup.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Environment diffuseOnly(const Sky& sky) {
    constexpr int size = 128;
    const OctahedralMap grid(size);
    DiffuseSum sum;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            sum.add(grid.direction(x, y), glm::vec3(sky(grid.direction(x, y))),
                    static_cast<double>(grid.solidAngle(x, y)));
    return {sum.coefficients(), Atlas()};
}

} // namespace

TEST(DiffuseSum, HarmonicsOfItsBandsAreExact) {
    // One of each harmonic, with its own factors.
    const Sky sky = [](const glm::dvec3& d) {
        return glm::dvec3(9.0 + 1.5 * d.x - 2.5 * d.y + 3.5 * d.z,
                          9.0 + 1.5 * d.x * d.y - 2.5 * d.y * d.z + 3.5 * d.z * d.x,
                          9.0 + 1.5 * d.z * d.z + 2.5 * (d.x * d.x - d.y * d.y));
    };
    const Environment environment = diffuseOnly(sky);
    for (const glm::vec3& normal : testDirections()) {
        const glm::vec3 expected(lambertByBruteForce(sky, glm::dvec3(normal)));
        EXPECT_LT(glm::length(test::environmentDiffuse(environment, normal) - expected), 0.01f);
    }
}

TEST(DiffuseSum, ASunIsCloseToBruteForce) {
    const Environment environment = diffuseOnly(lopsidedSky);
    float worst = 0.0f;
    for (const glm::vec3& normal : testDirections()) {
        const glm::vec3 expected(lambertByBruteForce(lopsidedSky, glm::dvec3(normal)));
        const glm::vec3 error = test::environmentDiffuse(environment, normal) - expected;
        for (int channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(error[channel]));
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LT(worst, 0.06f); // bands above the second are left out
}

TEST(DiffuseSum, TheMeanIsOverAllDirections) {
    DiffuseSum sum;
    sum.add({0.0f, 1.0f, 0.0f}, glm::vec3(4.0f), 1.0);
    sum.add({0.0f, -1.0f, 0.0f}, glm::vec3(0.0f, 4.0f, 8.0f), 3.0);
    EXPECT_EQ(sum.mean(), glm::dvec3(1.0, 4.0, 7.0));
}

} // namespace edgeshade::test
