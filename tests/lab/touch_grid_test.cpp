#include "src/shadow/layers/touch_grid.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using Triangle = std::array<glm::dvec2, 3>;

const Outline part{-0.7, 1.3, 2.0, 2.5};

class RandomTriangles {
  public:
    explicit RandomTriangles(unsigned seed) : random_(seed) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    glm::dvec2 inPart(double beyond) {
        const auto at = [&](double low, double high) {
            return low + (high - low) * ((1.0 + 2.0 * beyond) * unit() - beyond);
        };
        const double u = at(part.u0, part.u1);
        return {u, at(part.v0, part.v1)};
    }
    /// Large and small triangles, slivers, horizontal edges, corners on the borders of cells.
    Triangle next(int kind, int side) {
        Triangle triangle{inPart(0.3), inPart(0.3), inPart(0.3)};
        const glm::dvec2 cell((part.u1 - part.u0) / side, (part.v1 - part.v0) / side);
        if (kind == 1) triangle[2] = triangle[0] + 1e-9 * (triangle[1] - triangle[0]);
        if (kind == 2) triangle[1].y = triangle[0].y + 1e-12 * unit();
        if (kind == 3)
            for (glm::dvec2& corner : triangle)
                corner = glm::dvec2(part.u0, part.v0) +
                         cell * glm::round((corner - glm::dvec2(part.u0, part.v0)) / cell);
        if (kind == 4)
            for (int i = 1; i < 3; ++i)
                triangle[i] = triangle[0] + cell * glm::dvec2(3.0 * unit(), 3.0 * unit());
        return triangle;
    }
    glm::dvec2 within(const Triangle& t) {
        double a = unit(), b = unit();
        if (a + b > 1.0) {
            a = 1.0 - a;
            b = 1.0 - b;
        }
        return t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
    }

  private:
    std::mt19937 random_;
};

/// The count at a place in `part`.
std::size_t countAt(const TouchGrid& grid, const glm::dvec2& place) {
    const auto index = [&](double share) {
        return std::clamp(static_cast<int>(share * grid.side()), 0, grid.side() - 1);
    };
    return grid.count(index((place.y - part.v0) / (part.v1 - part.v0)),
                      index((place.x - part.u0) / (part.u1 - part.u0)));
}

bool holds(const Outline& outline, const glm::dvec2& place) {
    return !outline.misses({place.x, place.x, place.y, place.y});
}

TEST(TouchGrid, CountsATriangleWhereverItHasAPoint) {
    for (const int depth : {0, 2, 6})
        for (int i = 0; i < 500; ++i) {
            RandomTriangles random(static_cast<unsigned>(i));
            TouchGrid grid(part, depth);
            const Triangle triangle = random.next(i % 5, grid.side());
            grid.add(triangle);
            grid.sum();
            for (int p = 0; p < 200; ++p) {
                const glm::dvec2 place = random.within(triangle);
                if (!holds(part, place)) continue;
                ASSERT_EQ(countAt(grid, place), 1u) << depth << ", triangle " << i;
            }
        }
}

// For a triangle at the light only an outline is known.
TEST(TouchGrid, CountsOutlinesToo) {
    RandomTriangles random(3);
    for (int i = 0; i < 200; ++i) {
        TouchGrid grid(part, 5);
        const Triangle triangle = random.next(i % 5, grid.side());
        grid.add(outlineOf(triangle));
        grid.add(Outline{-INFINITY, INFINITY, -INFINITY, INFINITY});
        grid.sum();
        for (int p = 0; p < 50; ++p) {
            const glm::dvec2 place = random.within(triangle);
            if (!holds(part, place)) continue;
            ASSERT_EQ(countAt(grid, place), 2u);
        }
    }
}

// The grid's purpose: a long diagonal touches few cells of its outline.
TEST(TouchGrid, ADiagonalTouchesItsOwnCellsAlone) {
    TouchGrid grid({0, 1, 0, 1}, 6);
    grid.add(Triangle{glm::dvec2(0.01, 0.01), {0.99, 0.98}, {0.98, 0.99}});
    grid.sum();
    std::size_t touched = 0;
    for (int row = 0; row < grid.side(); ++row)
        for (int column = 0; column < grid.side(); ++column)
            touched += grid.count(row, column);
    EXPECT_GE(touched, 64u);
    EXPECT_LE(touched, 256u);
}

} // namespace
} // namespace edgeshade
