// Polygons in triangles, by both winding rules.

#include "preprocess/mesh/tessellation.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using Loops = std::vector<std::vector<glm::dvec3>>;

/// A square around the origin, counter-clockwise from above.
std::vector<glm::dvec3> square(double half) {
    return {{-half, -half, 0.0}, {half, -half, 0.0}, {half, half, 0.0}, {-half, half, 0.0}};
}

/// The area as seen from above; triangles that are clockwise count as negative.
double areaOf(const Loops& loops, WindingRule rule, std::size_t added = 0) {
    const auto made = tessellate(loops, {0.0, 0.0, 1.0}, rule);
    if (!made) return -1.0;
    EXPECT_EQ(made->added.size(), added);
    std::vector<glm::dvec3> corners;
    for (const std::vector<glm::dvec3>& loop : loops)
        corners.insert(corners.end(), loop.begin(), loop.end());
    corners.insert(corners.end(), made->added.begin(), made->added.end());
    double area = 0.0;
    for (const auto& [a, b, c] : made->triangles)
        area += 0.5 * glm::cross(corners.at(b) - corners.at(a), corners.at(c) - corners.at(a)).z;
    return area;
}

TEST(Tessellation, FollowsTheWindingRule) {
    const Loops nested = {square(2.0), square(1.0)};
    EXPECT_DOUBLE_EQ(areaOf(nested, WindingRule::odd), 12.0);
    EXPECT_DOUBLE_EQ(areaOf(nested, WindingRule::nonzero), 16.0);
    EXPECT_EQ(areaOf({}, WindingRule::odd), 0.0);
}

TEST(Tessellation, AddsCornersWhereLinesCross) {
    // Two triangles, which meet at the origin, as one loop.
    const Loops bow = {{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}}};
    EXPECT_DOUBLE_EQ(areaOf(bow, WindingRule::odd, 1), 2.0);
}

} // namespace
} // namespace edgeshade
