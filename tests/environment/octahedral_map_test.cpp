#include "src/environment/octahedral_map.hpp"

#include "tests/environment/sky.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade::test {

TEST(OctahedralMap, DirectionsComeBack) {
    for (const glm::vec3& direction : testDirections()) {
        const glm::vec2 at = octahedralFromDirection(direction);
        EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1.0f);
        EXPECT_LT(glm::length(directionFromOctahedral(at) - direction), 1e-6f);
    }
    EXPECT_EQ(octahedralFromDirection({0.0f, 1.0f, 0.0f}), glm::vec2(0.0f));
}

TEST(OctahedralMap, TexelsCoverTheSphere) {
    for (const int size : {16, 62, 64}) {
        const OctahedralMap map(size);
        double sum = 0.0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                sum += static_cast<double>(map.solidAngle(x, y));
        EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 0.01);
    }
}

TEST(OctahedralMap, FilteringHasNoSeam) {
    OctahedralMap map(8);
    float value = 0.0f; // neighbours differ by the full range
    map.fill([&](const glm::vec3&) { return glm::vec3(value = 1.0f - value, 0.5f, 0.0f); });
    for (int i = -20; i <= 20; ++i) {
        const float along = static_cast<float>(i) / 20.5f;
        constexpr float step = 1e-4f;
        for (const glm::vec2& out : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1)}) {
            const glm::vec2 edge = out + along * glm::vec2(out.y, out.x);
            const glm::vec2 across = out - along * glm::vec2(out.y, out.x);
            const glm::vec3 here = directionFromOctahedral(edge - step * out);
            const glm::vec3 there = directionFromOctahedral(across - step * out);
            ASSERT_LT(glm::length(here - there), 1e-3f); // the same place
            EXPECT_LT(glm::length(map.lookUp(here) - map.lookUp(there)), 4e-3f);
        }
    }
}

TEST(OctahedralMap, CornersMeet) {
    OctahedralMap map(8);
    map.fill([](const glm::vec3& direction) { return direction; });
    map.at(0, 0) = glm::vec3(1.0f);
    map.closeBorder();
    const glm::vec3 expected = 0.25f * (map.at(0, 0) + map.at(7, 0) + map.at(0, 7) + map.at(7, 7));
    for (const glm::vec2& corner : {glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(1, -1)})
        EXPECT_LT(glm::length(map.lookUp(directionFromOctahedral(corner)) - expected), 1e-5f);
}

TEST(OctahedralMap, WhatChangesSlowlyIsLookedUpClosely) {
    OctahedralMap map(62);
    map.fill([](const glm::vec3& direction) { return direction; });
    for (const glm::vec3& direction : testDirections())
        EXPECT_LT(glm::length(map.lookUp(direction) - direction), 0.03f); // half a texel at most
}

} // namespace edgeshade::test
