#include "preprocess/mesh/weld.hpp"
#include "tests/support/hard_lights.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade::test {
namespace {

using Positions = std::vector<glm::vec3>;

Positions snapped(Positions positions, double tolerance) {
    snapPositions(positions, tolerance);
    return positions;
}

Positions randomPositions(std::uint64_t seed, std::size_t count, double size) {
    Random random(seed);
    Positions positions;
    for (std::size_t i = 0; i < count; ++i)
        positions.emplace_back(size * random.inCube());
    return positions;
}

} // namespace

TEST(SnapPositions, CloserThanTheToleranceMovesOntoTheEarlier) {
    EXPECT_EQ(snapped({{1, 0, 0}, {1.25f, 0, 0}}, 0.5), (Positions{{1, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(snapped({{1.25f, 0, 0}, {1, 0, 0}}, 0.5), (Positions{{1.25f, 0, 0}, {1.25f, 0, 0}}));
}

TEST(SnapPositions, ExactlyTheToleranceApartStays) {
    const Positions apart = {{1, 0, 0}, {1.5f, 0, 0}};
    EXPECT_EQ(snapped(apart, 0.5), apart);
}

TEST(SnapPositions, DistanceIsEuclidean) {
    // (0.4, 0.4, 0.4) is 0.69 away: within 0.5 on every axis, but too far.
    const Positions apart = {{0, 0, 0}, {0.4f, 0.4f, 0.4f}};
    EXPECT_EQ(snapped(apart, 0.5), apart);
    EXPECT_EQ(snapped(apart, 0.7), (Positions{{0, 0, 0}, {0, 0, 0}}));
}

TEST(SnapPositions, CellBordersDoNotSeparate) {
    // On both sides of 0 and of 1, which are borders of the grid, in every direction.
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::vec3 below(0.5f), above(0.5f);
        below[axis] = -0.01f, above[axis] = 0.01f;
        EXPECT_EQ(snapped({below, above}, 1.0), (Positions{below, below}));
        below[axis] = 0.99f, above[axis] = 1.01f;
        EXPECT_EQ(snapped({above, below}, 1.0), (Positions{above, above}));
    }
}

TEST(SnapPositions, ChainsDoNotCreep) {
    // 0 -- 0.6 -- 1.2: the middle joins the first, the last is 1.2 away from it and stays.
    EXPECT_EQ(snapped({{0, 0, 0}, {0.6f, 0, 0}, {1.2f, 0, 0}}, 1.0),
              (Positions{{0, 0, 0}, {0, 0, 0}, {1.2f, 0, 0}}));
}

TEST(SnapPositions, OfSeveralTheFirstAttracts) {
    // 1 and -0.05 are 1.05 apart and stay; 0.5 is within 1 of both and goes to 1, which came first,
    // whichever grid cells they are in.
    EXPECT_EQ(snapped({{1, 0, 0}, {-0.05f, 0, 0}, {0.5f, 0, 0}}, 1.0),
              (Positions{{1, 0, 0}, {-0.05f, 0, 0}, {1, 0, 0}}));
}

TEST(SnapPositions, WhatIsLeftIsAtLeastTheToleranceApart) {
    const double tolerance = 0.2;
    const Positions result = snapped(randomPositions(1, 2000, 1.0), tolerance);
    const auto less = [](const glm::vec3& a, const glm::vec3& b) { return orderedBefore(a, b); };
    const std::set<glm::vec3, decltype(less)> distinct(result.begin(), result.end(), less);
    EXPECT_LT(distinct.size(), 1000u);
    for (auto a = distinct.begin(); a != distinct.end(); ++a)
        for (auto b = std::next(a); b != distinct.end(); ++b)
            EXPECT_GE(glm::distance(glm::dvec3(*a), glm::dvec3(*b)), tolerance);
}

TEST(SnapPositions, NoPositionMovesAsFarAsTheTolerance) {
    const Positions before = randomPositions(2, 2000, 1.0);
    const Positions after = snapped(before, 0.2);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT(glm::distance(glm::dvec3(before[i]), glm::dvec3(after[i])), 0.2);
}

TEST(SnapPositions, TwiceIsOnce) {
    const Positions once = snapped(randomPositions(3, 2000, 1.0), 0.2);
    EXPECT_EQ(snapped(once, 0.2), once);
}

TEST(SnapPositions, TheSameOrderGivesTheSameResult) {
    EXPECT_EQ(snapped(randomPositions(4, 2000, 1.0), 0.2),
              snapped(randomPositions(4, 2000, 1.0), 0.2));
}

TEST(SnapPositions, FarOffCoordinatesAreFine) {
    // 1e30 / 1e-6 fits no cell number.
    const Positions far = {{1e30f, 0, 0}, {1.1e30f, 0, 0}, {-1e30f, 1e30f, 0}};
    EXPECT_EQ(snapped(far, 1e-6), far);
}

} // namespace edgeshade::test
