#include "src/shadow/layers/face_bound.hpp"
#include "src/shadow/layers/winding_grid.hpp"
#include "tests/support/hard_lights.hpp"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;
using Triangle2 = std::array<glm::dvec2, 3>;

constexpr int latticeSide = 32;

/// Distance of a point of the lattice from its floats, if it isn't one of them.
constexpr double floatError = latticeSide * 0x1p-23;

double area(const Triangle2& t) {
    const glm::dvec2 b = t[1] - t[0], c = t[2] - t[0];
    return b.x * c.y - b.y * c.x;
}

/// Counter-clockwise triangles between points of a lattice, of any size.
std::vector<Triangle2> latticeTriangles(Random& random, int count) {
    std::vector<Triangle2> triangles;
    while (static_cast<int>(triangles.size()) < count) {
        const int reach = random.below(3) == 0 ? latticeSide : 4;
        const int x = random.below(latticeSide), y = random.below(latticeSide);
        Triangle2 t;
        for (glm::dvec2& corner : t)
            corner = {std::min(x + random.below(reach), latticeSide),
                      std::min(y + random.below(reach), latticeSide)};
        if (area(t) < 0.0) std::swap(t[1], t[2]);
        if (area(t) > 0.0) triangles.push_back(t);
    }
    return triangles;
}

/// A segment from its lower end to its upper one, which are off their places by up to `error`.
FaceSegment segmentBetween(const glm::vec2& from, const glm::vec2& to, int weight,
                           double error = floatError) {
    return {from, to, 0, static_cast<std::int16_t>(weight),
            static_cast<double>(to.y - from.y) <= 2.0001 * error};
}

/// Finds the paths of segments that meet at equal ends.
std::vector<FaceSegment> withPaths(std::vector<FaceSegment> segments) {
    std::map<std::pair<float, float>, std::uint32_t> numbers;
    const auto numberOf = [&](const glm::vec2& end) {
        const auto next = static_cast<std::uint32_t>(numbers.size());
        return numbers.try_emplace({end.x, end.y}, next).first->second;
    };
    ChainPaths paths;
    paths.begin(2 * segments.size(), segments.size());
    {
        ChainPaths::Adding adding(paths);
        for (std::size_t i = 0; i < segments.size(); ++i)
            adding.add(numberOf(segments[i].from), numberOf(segments[i].to), segments[i].weight, i);
    }
    paths.findStarts([&](std::size_t i, int starts) { segments[i].starts = starts; });
    return segments;
}

/// The boundary of the triangles, edge by edge.
std::vector<FaceSegment> boundaryOf(const std::vector<Triangle2>& triangles,
                                    double error = floatError) {
    std::vector<FaceSegment> segments;
    for (const Triangle2& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 a = t[i], b = t[(i + 1) % 3];
            const glm::vec2 from(a), to(b);
            // Left of an edge is inside.
            segments.push_back(from.y <= to.y ? segmentBetween(from, to, -1, error)
                                              : segmentBetween(to, from, 1, error));
        }
    return withPaths(std::move(segments));
}

int countAt(const std::vector<Triangle2>& triangles, const glm::dvec2& p) {
    int count = 0;
    for (const Triangle2& t : triangles)
        count += area({t[0], t[1], p}) > 0.0 && area({t[1], t[2], p}) > 0.0 &&
                 area({t[2], t[0], p}) > 0.0;
    return count;
}

bool isNextToAnEdge(const std::vector<Triangle2>& triangles, const glm::dvec2& p) {
    for (const Triangle2& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 a = t[i], along = t[(i + 1) % 3] - a;
            const double share =
                std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
            if (glm::distance(p, a + share * along) < 1e-9) return true;
        }
    return false;
}

WindingGrid filled(const Outline& outline, int depth, double error,
                   const std::vector<FaceSegment>& segments, int start) {
    WindingGrid grid(outline, depth, error);
    std::vector<int> places;
    grid.add(segments, places);
    grid.sum(start);
    return grid;
}

/// Expects every count of places in a cell to be within its bound.
void expectBounds(const WindingGrid& grid, const std::vector<Triangle2>& triangles,
                  Random& random) {
    for (int row = 0; row < grid.side(); ++row)
        for (int column = 0; column < grid.side(); ++column) {
            const Outline cell = grid.cell(row, column);
            for (int i = 0; i < 6; ++i) {
                const double u = random.uniform(0, 1), v = random.uniform(0, 1);
                const glm::dvec2 p(glm::mix(cell.u0, cell.u1, u), glm::mix(cell.v0, cell.v1, v));
                ASSERT_LE(countAt(triangles, p), grid.bound(row, column))
                    << row << ", " << column << ": " << p.x << ", " << p.y;
            }
        }
}

TEST(WindingGrid, CountsExactlyAtCorners) {
    Random random(1);
    for (int round = 0; round < 60; ++round) {
        const std::vector<Triangle2> triangles = latticeTriangles(random, 1 + round / 2);
        const WindingGrid grid =
            filled({0, latticeSide, 0, latticeSide}, 5, 0.0, boundaryOf(triangles), 0);
        for (int row = 0; row < latticeSide; ++row)
            for (int column = 0; column < latticeSide; ++column) {
                if (isNextToAnEdge(triangles, {column, row})) continue;
                ASSERT_EQ(grid.corner(row, column), countAt(triangles, {column, row}));
            }
    }
}

TEST(WindingGrid, NoCountInACellIsAboveItsBound) {
    Random random(2);
    for (int round = 0; round < 60; ++round) {
        const std::vector<Triangle2> triangles = latticeTriangles(random, 1 + round);
        const std::vector<FaceSegment> segments = boundaryOf(triangles);
        for (const int depth : {0, 2, 4, 5})
            expectBounds(filled({0, latticeSide, 0, latticeSide}, depth, 0.0, segments, 0),
                         triangles, random);
    }
}

/// Finer grids in all cells of a grid, each with its own segments alone.
void expectFinerBounds(const WindingGrid& grid, double error,
                       const std::vector<FaceSegment>& segments,
                       const std::vector<Triangle2>& triangles, Random& random) {
    const auto index = [&](int row, int column) {
        return static_cast<std::size_t>(row * grid.side() + column);
    };
    std::vector<std::vector<FaceSegment>> own(index(grid.side(), 0));
    for (const FaceSegment& segment : segments)
        grid.forEachSpan(segment, [&](int row, int left, int right) {
            for (int column = left; column <= right; ++column)
                own[index(row, column)].push_back(segment);
        });
    for (int row = 0; row < grid.side(); ++row)
        for (int column = 0; column < grid.side(); ++column)
            expectBounds(filled(grid.cell(row, column), 2, error, own[index(row, column)],
                                grid.corner(row, column)),
                         triangles, random);
}

// Tenths are no doubles: corners, borders and vertices are in line, but for rounding.
TEST(WindingGrid, CellsAreDividedWithTheirOwnSegmentsAlone) {
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        std::vector<Triangle2> triangles = latticeTriangles(random, 1 + round / 2);
        for (Triangle2& t : triangles)
            for (glm::dvec2& corner : t)
                corner = 0.1 * corner + 0.7;
        const std::vector<FaceSegment> segments = boundaryOf(triangles);
        const Outline outline{0.7, 0.7 + 0.1 * latticeSide, 0.7, 0.7 + 0.1 * latticeSide};
        const WindingGrid grid = filled(outline, 3, floatError, segments, 0);
        expectBounds(grid, triangles, random);
        expectFinerBounds(grid, floatError, segments, triangles, random);
    }
}

// The vertices are known to an error that is a share of a cell.
TEST(WindingGrid, BoundsHoldForAnyPlaceWithinTheError) {
    Random random(4);
    constexpr double error = 0.05;
    for (int round = 0; round < 100; ++round) {
        const std::vector<Triangle2> triangles = latticeTriangles(random, 1 + round / 3);
        std::vector<Triangle2> placed = triangles;
        std::map<std::pair<double, double>, glm::dvec2> known; // edges meet at vertices
        for (Triangle2& t : placed)
            for (glm::dvec2& corner : t) {
                const glm::dvec2 off(random.uniform(-1, 1), random.uniform(-1, 1));
                corner = known.try_emplace({corner.x, corner.y}, corner + 0.7 * error * off)
                             .first->second;
            }
        const std::vector<FaceSegment> segments = boundaryOf(placed, error);
        const Outline outline{-0.1, latticeSide, -0.1, latticeSide};
        const WindingGrid grid = filled(outline, 4, error, segments, 0);
        expectBounds(grid, triangles, random);
        expectFinerBounds(grid, error, segments, triangles, random);
    }
}

/// Segments of any length and direction, many of them along or next to rows and columns of cells.
std::vector<FaceSegment> randomSegments(Random& random, int count) {
    std::vector<FaceSegment> segments;
    const auto coordinate = [&](double near) {
        const double at = near + random.magnitude(-9, 0) * random.uniform(-1, 1);
        return static_cast<float>(random.below(3) == 0 ? std::round(8.0 * at) / 8.0 : at);
    };
    while (static_cast<int>(segments.size()) < count) {
        const double x = random.uniform(-0.1, 1.1), y = random.uniform(-0.1, 1.1);
        glm::vec2 from(coordinate(x), coordinate(y)), to(coordinate(x), coordinate(y));
        if (random.below(8) == 0) to.x = from.x;
        if (random.below(8) == 0) to.y = from.y;
        if (from.y > to.y) std::swap(from, to);
        segments.push_back(
            segmentBetween(from, to, random.below(2) == 0 ? -1 - random.below(3) : 2));
    }
    return withPaths(std::move(segments));
}

// A single segment is counted by itself.
TEST(WindingGrid, FourSegmentsAtOnceCountAsOneByOne) {
    Random random(5);
    for (int round = 0; round < 400; ++round) {
        const Outline outline{0.0, 1.0, 0.0, 1.0};
        const int depth = random.below(6);
        const double error = random.magnitude(-9, -2);
        const std::vector<FaceSegment> segments = randomSegments(random, 97);
        const WindingGrid together = filled(outline, depth, error, segments, 0);
        WindingGrid apart(outline, depth, error);
        std::vector<int> places;
        for (const FaceSegment& segment : segments)
            apart.add({&segment, 1}, places);
        apart.sum(0);
        for (int row = 0; row < together.side(); ++row)
            for (int column = 0; column < together.side(); ++column) {
                ASSERT_EQ(together.corner(row, column), apart.corner(row, column));
                ASSERT_EQ(together.bound(row, column), apart.bound(row, column));
            }
    }
}

TEST(WindingGrid, SegmentsTouchNoCellsBesideTheirPlaces) {
    Random random(6);
    int only = 0, inSquares = 0;
    for (int round = 0; round < 100; ++round) {
        WindingGrid grid({0.0, 1.0, 0.0, 1.0}, 1 + random.below(5), random.magnitude(-9, -2));
        const std::vector<FaceSegment> segments = randomSegments(random, 96);
        std::vector<int> places;
        grid.add(segments, places);
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const int place = places[i];
            if (place == grid.elsewhere()) continue;
            const bool isOnly = place >= 0;
            ++(isOnly ? only : inSquares);
            const int first = isOnly ? place : WindingGrid::inSquare(place);
            const int last = isOnly ? 0 : 1;
            grid.forEachSpan(segments[i], [&](int row, int left, int right) {
                ASSERT_GE(row, first / grid.side());
                ASSERT_LE(row, first / grid.side() + last);
                ASSERT_GE(left, first % grid.side());
                ASSERT_LE(right, first % grid.side() + last);
            });
        }
    }
    EXPECT_GT(only, 1000);
    EXPECT_GT(inSquares, 1000);
}

/// The most triangles found at any point of a fine lattice.
int mostFound(const std::vector<Triangle2>& triangles) {
    int most = 0;
    for (double x = 0.13; x < latticeSide; x += 0.25)
        for (double y = 0.11; y < latticeSide; y += 0.25)
            most = std::max(most, countAt(triangles, {x, y}));
    return most;
}

TEST(FaceBound, NoLimitBelowTheTruthHolds) {
    Random random(7);
    int shown = 0;
    for (int round = 0; round < 150; ++round) {
        const std::vector<Triangle2> triangles = latticeTriangles(random, 1 + round / 5);
        FaceChain face;
        face.segments = boundaryOf(triangles);
        const Outline filledOutline{-0.1, latticeSide + 0.2, -0.1, latticeSide + 0.3};
        const int truth = mostFound(triangles);
        for (const int limit : {truth - 1, truth, truth + 1, truth + 3}) {
            if (limit < 0) continue;
            FaceBound bound(static_cast<std::size_t>(limit));
            if (!bound.holds(face, filledOutline, 0)) continue;
            ++shown;
            EXPECT_GE(bound.most(), truth) << limit;
        }
    }
    EXPECT_GT(shown, 60);
}

// A small triangle is within two equal ones, whose four sides come from the cell below.
TEST(FaceBound, ACrowdedCellHasTheSidesFromTheCellBelow) {
    const auto at = [](double x, double y) { return glm::dvec2(x, y); };
    const Triangle2 large{at(5.5, 4.6), at(5.9, 5.8), at(5.1, 5.7)};
    const Triangle2 small{at(5.45, 5.5), at(5.55, 5.52), at(5.5, 5.6)};
    FaceChain face;
    face.segments = boundaryOf({large, large, small});
    const Outline cells{4, 8, 4, 8}; // the grid has as many
    EXPECT_FALSE(FaceBound(2).holds(face, cells, 0));
    EXPECT_TRUE(FaceBound(6).holds(face, cells, 0));
}

// Ten edges pass through the corner of a cell, which is divided until it holds nothing else.
TEST(FaceBound, SegmentsAtASharedCornerRaiseItOnce) {
    Random random(9);
    std::vector<Triangle2> triangles;
    for (int i = 0; i < 10; ++i) {
        const glm::dvec2 along(0.3 + 0.05 * i, 1.0);
        triangles.push_back(
            {glm::dvec2(4.0) - along, glm::dvec2(4.0) + along, glm::dvec2(2.5, 5.0)});
    }
    for (int i = 0; i < 30; ++i) {
        const glm::dvec2 at(4.9 + 0.02 * random.uniform(-1, 1), 4.9 + 0.02 * random.uniform(-1, 1));
        triangles.push_back({at, at + glm::dvec2(0.04, 0.0), at + glm::dvec2(0.0, 0.04)});
    }
    FaceChain face;
    face.segments = boundaryOf(triangles);
    const Outline cells{0, 16, 0, 16};
    EXPECT_TRUE(FaceBound(45).holds(face, cells, 0));
}

// The grid's purpose: a triangle's cells have its count, and a long edge touches few of them.
TEST(WindingGrid, BoundsAreTightAwayFromEdges) {
    const std::vector<Triangle2> triangles{{glm::dvec2(0.3, 0.2), {31.6, 0.4}, {0.7, 31.8}}};
    const WindingGrid grid =
        filled({0, latticeSide, 0, latticeSide}, 5, 0.0, boundaryOf(triangles), 0);
    int full = 0, above = 0;
    for (int row = 0; row < grid.side(); ++row)
        for (int column = 0; column < grid.side(); ++column) {
            full += grid.bound(row, column) >= 1;
            above += grid.bound(row, column) > 1;
        }
    EXPECT_LE(above, 3); // where two edges meet
    EXPECT_LE(full, latticeSide * latticeSide / 2 + 4 * latticeSide);
    EXPECT_GE(full, latticeSide * latticeSide / 2);
}

/// A regular polygon, counter-clockwise.
std::vector<glm::dvec2> regularPolygon(const glm::dvec2& center, double radius, double turn) {
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < 40; ++i) {
        const double at = turn + i * 0.05 * glm::pi<double>();
        corners.push_back(center + radius * glm::dvec2(std::cos(at), std::sin(at)));
    }
    return corners;
}

// However many edges a convex outline has, it counts once: as one path, or at the corner.
TEST(WindingGrid, ConvexOutlinesCountOnceInEachCell) {
    Random random(8);
    int above = 0, cells = 0;
    for (int round = 0; round < 40; ++round) {
        std::vector<FaceSegment> segments;
        std::vector<std::pair<glm::dvec2, double>> circles;
        for (int i = 0; i < 30; ++i) {
            const glm::dvec2 center(random.uniform(0, 1), random.uniform(0, 1));
            const double radius = random.magnitude(-1.2, -0.5);
            circles.emplace_back(center, radius);
            const auto corners = regularPolygon(center, radius, random.uniform(0, 1));
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const glm::vec2 a(corners[k]), b(corners[(k + 1) % corners.size()]);
                segments.push_back(a.y <= b.y ? segmentBetween(a, b, -1) : segmentBetween(b, a, 1));
            }
        }
        const Outline outline{-0.4, 1.4, -0.4, 1.4};
        const WindingGrid grid =
            filled(outline, random.below(6), 0.0, withPaths(std::move(segments)), 0);
        for (int row = 0; row < grid.side(); ++row)
            for (int column = 0; column < grid.side(); ++column) {
                const Outline cell = grid.cell(row, column);
                int touching = 0;
                for (const auto& [center, radius] : circles) {
                    const glm::dvec2 nearest =
                        glm::clamp(center, {cell.u0, cell.v0}, {cell.u1, cell.v1});
                    touching += glm::distance(center, nearest) < radius;
                }
                above += grid.bound(row, column) > touching;
                ++cells;
            }
    }
    EXPECT_LE(above, cells / 200) << "but next to corners, and for edges that are nearly level";
}

TEST(WindingGrid, ASegmentTouchesNoCellOutsideOfItsRowsAndColumns) {
    Random random(54);
    int spans = 0, without = 0;
    for (int i = 0; i < 2000; ++i) {
        const WindingGrid grid({0.0, 1.0, 0.0, 2.0}, 1 + random.below(6),
                               random.magnitude(-15, -2));
        glm::dvec2 from(random.uniform(-0.5, 1.5), random.uniform(-0.5, 2.5));
        glm::dvec2 to(random.uniform(-0.5, 1.5), random.uniform(-0.5, 2.5));
        if (random.below(3) == 0) to = from + 0.01 * (to - from);
        if (random.below(5) == 0) to.y = from.y;
        if (from.y > to.y) std::swap(from, to);
        const FaceSegment segment = segmentBetween(glm::vec2(from), glm::vec2(to), 1);
        const auto cells = grid.cellsAround(segment);
        without += cells ? 0 : 1;
        grid.forEachSpan(segment, [&](int row, int left, int right) {
            ++spans;
            ASSERT_TRUE(cells) << i;
            EXPECT_TRUE(cells->bottom <= row && row <= cells->top) << i;
            EXPECT_TRUE(cells->left <= left && right <= cells->right) << i;
        });
    }
    EXPECT_GT(spans, 1000);
    EXPECT_GT(without, 10);
}

} // namespace
} // namespace edgeshade
