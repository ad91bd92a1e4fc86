#include "src/environment/radiance_encoding.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace edgeshade::test {
namespace {

glm::vec4 storedOf(const glm::vec3& radiance) {
    const auto bytes = encodeRadiance(radiance);
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
}

std::vector<float> sizes() {
    std::vector<float> sizes;
    for (float size = 1e-4f; size < largestEncodedRadiance(); size *= 1.003f)
        sizes.push_back(size);
    return sizes;
}

} // namespace

TEST(RadianceEncoding, ErrorsAreAsSmallAsItSays) {
    for (const float size : sizes())
        for (const float share : {1.0f, 0.9f, 0.7f, 0.5f}) {
            const glm::vec3 radiance(size, share * size, 0.5f * size);
            const glm::vec3 decoded = decodeRadiance(storedOf(radiance));
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(decoded[channel], radiance[channel],
                            size >= 0.25f ? 0.01f * radiance[channel] : 0.004f)
                    << size;
        }
}

TEST(RadianceEncoding, DarkerThanHalfACodeOfTheDisplayIsNoError) {
    // 1 / (255 * 12.92) is a step of sRGB next to black, the smallest there is.
    for (const float size : sizes()) {
        if (size > 0.01f) break;
        const float decoded = decodeRadiance(storedOf(glm::vec3(size))).g;
        ASSERT_NEAR(decoded, size, 0.5f * 12.92f / (255.0f * 12.92f)) << size;
    }
}

TEST(RadianceEncoding, BlackAndTheLargestAreExact) {
    EXPECT_EQ(decodeRadiance(storedOf(glm::vec3(0.0f))), glm::vec3(0.0f));
    const float largest = largestEncodedRadiance();
    EXPECT_EQ(decodeRadiance(storedOf(glm::vec3(largest))), glm::vec3(largest));
    EXPECT_EQ(decodeRadiance(storedOf(glm::vec3(1e30f))), glm::vec3(largest));
}

TEST(RadianceEncoding, FilteringStaysBetweenNeighboursAndKeepsGreyGrey) {
    for (const float size : sizes()) {
        if (1.2f * size > largestEncodedRadiance()) break;
        const glm::vec3 one(size), other(1.2f * size);
        for (const float share : {0.25f, 0.5f, 0.75f}) {
            const glm::vec3 between =
                decodeRadiance(glm::mix(storedOf(one), storedOf(other), share));
            const float expected = glm::mix(size, 1.2f * size, share);
            ASSERT_EQ(between.r, between.b);
            ASSERT_NEAR(between.r, expected, std::max(0.015f * expected, 0.004f)) << size;
        }
    }
}

} // namespace edgeshade::test
