// The triangle that a vertical line meets first.

#include "src/city/top_surface.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade::city {
namespace {

CityTriangle triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return {{a, b, c}};
}

TEST(TopSurface, IsTheHighest) {
    const std::vector<CityTriangle> triangles = {triangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}),
                                                 triangle({0, 0, 3}, {4, 0, 3}, {0, 4, 3})};
    const auto tops = topSurfaces(triangles, {0, 0, 4, 4}, 1.0);
    EXPECT_EQ(tops[0], 1u);
    EXPECT_EQ(tops[3 * 4 + 3], 0u);
    const auto none = topSurfaces(triangles, {20, 20, 21, 21}, 1.0);
    EXPECT_EQ(none[0], noSurface);
}

TEST(TopSurface, OneUnitOfHeightDecides) {
    // Two slopes whose heights over the middle differ by less than a thousandth of a unit.
    const double far = 4096.0;
    const CityTriangle low = triangle({-far, -far, 0}, {far, -far, 1.0}, {0.5, far, latticeUnit});
    CityTriangle high = low;
    high.corners[0].z += latticeUnit;
    for (const bool swapped : {false, true}) {
        const std::vector<CityTriangle> both =
            swapped ? std::vector{high, low} : std::vector{low, high};
        // Near the third corner the first one's weight is about 1e-4.
        const CellRange cell{0, 4095, 1, 4096};
        EXPECT_EQ(topSurfaces(both, cell, 1.0)[0], swapped ? 0u : 1u);
    }
}

TEST(TopSurface, TiesDontDependOnTheOrder) {
    const CityTriangle left = triangle({0, 0, 0}, {2, 0, 0}, {0, 2, 2}),
                       right = triangle({2, 0, 0}, {2, 2, 0}, {0, 2, 2});
    const std::vector<CityTriangle> one = {left, right}, other = {right, left};
    // Cells whose middles are on the edge that both share.
    for (const std::int64_t i : {0, 1}) {
        const CellRange cell{i, 1 - i, i + 1, 2 - i};
        const std::uint32_t a = topSurfaces(one, cell, 1.0)[0],
                            b = topSurfaces(other, cell, 1.0)[0];
        ASSERT_NE(a, noSurface);
        EXPECT_EQ(a, 1 - b);
    }
}

TEST(TopSurface, FarFromTheOriginNothingChanges) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> units(0, 16 * 1024);
    std::vector<CityTriangle> here, there;
    const glm::dvec3 far(0x1p28, -0x1p28, 0.0);
    for (int t = 0; t < 200; ++t) {
        CityTriangle& made = here.emplace_back();
        for (glm::dvec3& corner : made.corners)
            corner = latticeUnit * glm::dvec3(units(random), units(random), units(random));
        there.push_back(made);
        for (glm::dvec3& corner : there.back().corners)
            corner += far;
    }
    const auto shift = static_cast<std::int64_t>(far.x);
    EXPECT_EQ(topSurfaces(here, {0, 0, 16, 16}, 1.0),
              topSurfaces(there, {shift, -shift, shift + 16, 16 - shift}, 1.0));
}

} // namespace
} // namespace edgeshade::city
