#include "src/rivals/maps/warp_cuts.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int cells = MapWarp::cells;

/// Places around a point, denser close to it, and some everywhere.
std::vector<glm::dvec2> placesAround(const glm::dvec2& middle) {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const glm::dvec2 at((i + 0.5) / 60.0, (j + 0.5) / 60.0);
            places.push_back(at);
            places.push_back(glm::mix(middle, at, 0.2));
            places.push_back(glm::mix(middle, at, 0.1));
        }
    return places;
}

/// A strip along the diagonal.
std::vector<glm::dvec2> diagonalPlaces() {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 4000; ++i) {
        const double along = i / 4000.0, aside = 0.04 * (i % 7 - 3) / 3.0;
        places.emplace_back(0.1 + 0.8 * along + aside, 0.1 + 0.8 * along - aside);
    }
    return places;
}

/// Four spots that different rows and columns see.
std::vector<glm::dvec2> spots() {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 1000; ++i)
        for (const glm::dvec2& spot : {glm::dvec2(0.1, 0.45), glm::dvec2(0.45, 0.9),
                                       glm::dvec2(0.9, 0.55), glm::dvec2(0.55, 0.1)})
            places.push_back(spot + 0.01 * glm::dvec2(i % 10, i / 100));
    return places;
}

/// Twice the areas of a cell's two halves in the texture.
glm::dvec2 areasOf(const MapWarp& warp, int x, int y) {
    const glm::dvec2 first = warp.node(x, y), across = warp.node(x + 1, y + 1) - first;
    const glm::dvec2 right = warp.node(x + 1, y) - first, up = warp.node(x, y + 1) - first;
    return {right.x * across.y - right.y * across.x, across.x * up.y - across.y * up.x};
}

class Warps : public testing::TestWithParam<WarpGrid> {};

TEST_P(Warps, FoldNowhereAndReachTheFrame) {
    for (const auto& places :
         {placesAround({0.2, 0.7}), diagonalPlaces(), spots(), {}, {glm::dvec2(0.4, 0.9)}}) {
        const MapWarp warp = mapWarp(GetParam(), places, 0.01);
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                const glm::dvec2 areas = areasOf(warp, x, y);
                ASSERT_GT(areas.x, 0.0) << x << " " << y;
                ASSERT_GT(areas.y, 0.0) << x << " " << y;
            }
        for (int i = 0; i <= cells; ++i) {
            EXPECT_NEAR(warp.node(0, i).x, 0.01, 1e-9);
            EXPECT_NEAR(warp.node(cells, i).x, 0.99, 1e-9);
            EXPECT_NEAR(warp.node(i, 0).y, 0.01, 1e-9);
            EXPECT_NEAR(warp.node(i, cells).y, 0.99, 1e-9);
        }
    }
}

TEST_P(Warps, GiveMoreTexelsWhereMoreIsSeen) {
    const glm::dvec2 middle(0.2, 0.7);
    const MapWarp warp = mapWarp(GetParam(), placesAround(middle), 0.0);
    const glm::ivec2 there(warp.inLattice(middle)), elsewhere(warp.inLattice({0.8, 0.2}));
    EXPECT_GT(areasOf(warp, there.x, there.y).x, 4.0 * areasOf(warp, elsewhere.x, elsewhere.y).x);
}

TEST_P(Warps, HaveTheirLinesWhereTheLatticeSays) {
    const MapWarp warp = mapWarp(GetParam(), placesAround({0.5, 0.5}), 0.0);
    for (int i = 0; i <= cells; ++i)
        EXPECT_NEAR(warp.inLattice(warp.line(i)).x, i, 1e-9);
}

TEST_P(Warps, CutCastersIntoAllOfThem) {
    const MapWarp warp = mapWarp(GetParam(), diagonalPlaces(), 0.01);
    const WarpCuts cuts(warp);
    const std::array<glm::dvec3, 3> caster = {glm::dvec3(0.03, 0.1, 0.2), glm::dvec3(0.9, 0.3, 0.5),
                                              glm::dvec3(0.4, 0.97, 0.7)};
    std::vector<WarpedCorner> pieces;
    cuts.add(caster, pieces);
    ASSERT_GT(pieces.size(), 100u);
    double area = 0.0;
    for (std::size_t i = 0; i < pieces.size(); i += 3) {
        const glm::dvec3 &a = pieces[i].weights, &b = pieces[i + 1].weights;
        const glm::dvec3& c = pieces[i + 2].weights;
        area += glm::dot(glm::cross(a, b), c);
        // All of a piece agrees on the position of its middle.
        std::vector<WarpedCorner> point;
        const glm::dvec3 weights = (a + b + c) / 3.0;
        const glm::dvec3 at = weights.x * caster[0] + weights.y * caster[1] + weights.z * caster[2];
        cuts.add({at, at + glm::dvec3(1e-9, 0, 0), at + glm::dvec3(0, 1e-9, 0)}, point);
        ASSERT_FALSE(point.empty());
        const glm::dvec3 middle =
            (pieces[i].place + pieces[i + 1].place + pieces[i + 2].place) / 3.0;
        EXPECT_LT(glm::distance(point[0].place, middle), 1e-6);
    }
    EXPECT_NEAR(area, 1.0, 1e-6);
}

TEST_P(Warps, LeaveSmallCastersWhole) {
    const MapWarp warp = mapWarp(GetParam(), {}, 0.0);
    const glm::dvec2 inCell = warp.line(5) + glm::dvec2(0.7, 0.3) * (warp.line(6) - warp.line(5));
    std::vector<WarpedCorner> pieces;
    WarpCuts(warp).add({glm::dvec3(inCell, 0.5), glm::dvec3(inCell + glm::dvec2(1e-6, 0), 0.5),
                        glm::dvec3(inCell + glm::dvec2(0, 1e-6), 0.6)},
                       pieces);
    EXPECT_EQ(pieces.size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(, Warps, testing::Values(WarpGrid::rectilinear, WarpGrid::nonOrthogonal),
                         [](const auto& instance) {
                             return std::string(instance.param == WarpGrid::rectilinear
                                                    ? "rectilinear"
                                                    : "nonOrthogonal");
                         });

// A rectilinear grid shares its columns between rows; in the other grid each row has its own.
TEST(NonOrthogonalWarp, SpendsLessBesideADiagonal) {
    const auto shareOnDiagonal = [](WarpGrid grid) {
        const MapWarp warp = mapWarp(grid, diagonalPlaces(), 0.0);
        double share = 0.0;
        for (int i = 1; i + 1 < cells; ++i)
            for (int j = std::max(1, i - 2); j <= std::min(cells - 2, i + 2); ++j) {
                const glm::dvec2 areas = areasOf(warp, i, j);
                share += 0.5 * (areas.x + areas.y);
            }
        return share;
    };
    EXPECT_GT(shareOnDiagonal(WarpGrid::nonOrthogonal),
              1.5 * shareOnDiagonal(WarpGrid::rectilinear));
}

} // namespace
} // namespace edgeshade
