#include "src/environment/radiance_encoding.hpp"
#include "tests/support/environment_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace edgeshade::test {
namespace {

constexpr float roots[] = {0.5f, 1.7f, 8.0f};

glm::vec4 storedOf(const glm::vec3& radiance, float root) {
    const auto bytes = encodeRadiance(radiance, root);
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
}

std::vector<float> sizesUpTo(float largest) {
    std::vector<float> sizes;
    for (float size = 1e-5f; size < largest; size *= 1.003f)
        sizes.push_back(size);
    return sizes;
}

float allowed(float radiance, float root, float share) {
    return std::max(share * radiance, 0.001f * root * std::sqrt(radiance) + 1e-6f * root * root);
}

} // namespace

TEST(RadianceEncoding, ErrorsAreAsSmallAsItSays) {
    for (const float root : roots)
        for (const float size : sizesUpTo(root * root))
            for (const float share : {1.0f, 0.9f, 0.7f, 0.5f}) {
                const glm::vec3 radiance(size, share * size, 0.5f * size);
                const glm::vec3 decoded = test::decodeRadiance(storedOf(radiance, root), root);
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(decoded[channel], radiance[channel],
                                allowed(radiance[channel], root, 0.01f))
                        << size << " of " << root * root;
            }
}

TEST(RadianceEncoding, BlackAndTheLargestAreExact) {
    for (const float root : roots) {
        EXPECT_EQ(test::decodeRadiance(storedOf(glm::vec3(0.0f), root), root), glm::vec3(0.0f));
        const float largest = root * root;
        EXPECT_EQ(test::decodeRadiance(storedOf(glm::vec3(largest), root), root),
                  glm::vec3(largest));
        EXPECT_EQ(test::decodeRadiance(storedOf(glm::vec3(1e30f), root), root), glm::vec3(largest));
    }
}

TEST(RadianceEncoding, FilteringIsCloseToLinearAndKeepsGreyGrey) {
    for (const float root : roots)
        for (const float size : sizesUpTo(root * root / 1.2f)) {
            const glm::vec4 one = storedOf(glm::vec3(size), root);
            const glm::vec4 other = storedOf(glm::vec3(1.2f * size), root);
            for (const float share : {0.25f, 0.5f, 0.75f}) {
                const glm::vec3 between = test::decodeRadiance(glm::mix(one, other, share), root);
                const float expected = glm::mix(size, 1.2f * size, share);
                ASSERT_EQ(between.r, between.b);
                // Roots are filtered: the result is below the mean by a quarter of their difference
                // squared.
                ASSERT_NEAR(between.r, expected,
                            0.0025f * expected + allowed(expected, root, 0.01f))
                    << size;
            }
        }
}

} // namespace edgeshade::test
