#include "src/hours/surfaces/division.hpp"

#include "preprocess/base/error.hpp"
#include "tests/support/scene_builder.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

namespace edgeshade::hours {
namespace {

using test::SceneBuilder;

SurfaceCells divided(const Scene& scene, double width, double offset = 0.0) {
    return cellsOf(scene, [](std::uint32_t, std::uint32_t) { return true; }, {width, offset});
}

double sumOfAreas(const SurfaceCells& cells) {
    return std::accumulate(cells.cells.begin(), cells.cells.end(), 0.0,
                           [](double sum, const Cell& cell) { return sum + cell.area; });
}

double areaOfMesh(const SurfaceCells& cells) {
    return std::accumulate(
        cells.triangles.begin(), cells.triangles.end(), 0.0,
        [](double sum, const WorldTriangle& triangle) { return sum + areaOf(triangle); });
}

/// Twice the area of a cell's faces, from their corners.
double areaOfFaces(const SurfaceCells& cells, const Cell& cell) {
    double area = 0.0;
    for (std::uint32_t f = cell.firstFace; f < cell.firstFace + cell.faceCount; ++f) {
        const CellFace& face = cells.faces[f];
        const glm::dvec3* corner = &cells.corners[face.firstCorner];
        for (std::uint32_t i = 2; i < face.cornerCount; ++i)
            area += 0.5 * glm::dot(cell.normal,
                                   glm::cross(corner[i - 1] - corner[0], corner[i] - corner[0]));
    }
    return area;
}

/// Distance from a point to the plane of its triangle, and whether it is within the triangle.
void expectOnTriangle(const SurfaceCells& cells, const Cell& cell, double tolerance) {
    const WorldTriangle& triangle = cells.triangleOf(cell);
    const glm::dvec3 normal = glm::normalize(normalOf(triangle));
    const glm::dvec3 foot = cells.footOf(cell);
    EXPECT_NEAR(glm::dot(normal, foot - triangle.a), 0.0, tolerance);
    for (const auto& [p, q] : {std::pair(triangle.a, triangle.b), std::pair(triangle.b, triangle.c),
                               std::pair(triangle.c, triangle.a)})
        EXPECT_GE(glm::dot(normal, glm::cross(q - p, foot - p)), -tolerance * glm::length(q - p));
}

} // namespace

TEST(SurfaceCells, OfAWallAreOneGridOverItsTwoTriangles) {
    // 4 x 3 with cells of 0.5: 8 x 6, all whole.
    const SurfaceCells cells =
        divided(SceneBuilder().quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}).scene(), 0.5);
    ASSERT_EQ(cells.cells.size(), 48u);
    std::set<std::pair<long, long>> middles;
    for (const Cell& cell : cells.cells) {
        EXPECT_NEAR(cell.area, 0.25, 1e-12);
        EXPECT_EQ(cell.normal, glm::dvec3(0, 0, 1));
        EXPECT_EQ(cell.point.z, 0.0);
        // In the middle, but for a hair beside the wall's diagonal.
        const double x = 2.0 * cell.point.x - 0.5, y = 2.0 * cell.point.y - 0.5;
        EXPECT_NEAR(x, std::round(x), 0.01);
        EXPECT_NEAR(y, std::round(y), 0.01);
        middles.emplace(std::lround(x), std::lround(y));
        expectOnTriangle(cells, cell, 1e-12);
    }
    EXPECT_EQ(middles.size(), 48u);
}

TEST(SurfaceCells, AreEqualAndNoWiderThanTheGrid) {
    // 3.3 x 1 with cells of at most 0.5: 7 x 2 of 0.4714 x 0.5.
    const SurfaceCells cells =
        divided(SceneBuilder().quad({0, 0, 0}, {3.3f, 0, 0}, {3.3f, 1, 0}, {0, 1, 0}).scene(), 0.5);
    ASSERT_EQ(cells.cells.size(), 14u);
    for (const Cell& cell : cells.cells)
        EXPECT_NEAR(cell.area, 3.3 / 14.0, 1e-7);
}

TEST(SurfaceCells, ClippedByTheBorderHaveTheirTrueArea) {
    // A right triangle of 1 x 1 with cells of 0.5: one whole cell and two halves.
    const SurfaceCells cells =
        divided(SceneBuilder().triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).scene(), 0.5);
    ASSERT_EQ(cells.cells.size(), 3u);
    EXPECT_NEAR(cells.cells[0].area, 0.25, 1e-15);
    EXPECT_NEAR(cells.cells[1].area, 0.125, 1e-15);
    EXPECT_NEAR(cells.cells[2].area, 0.125, 1e-15);
    for (const Cell& cell : cells.cells) {
        expectOnTriangle(cells, cell, 1e-15);
        EXPECT_NEAR(areaOfFaces(cells, cell), cell.area, 1e-15);
    }
}

TEST(SurfaceCells, OfAnLKeepTheirSensorsOnIt) {
    // A cell of 2 holds the whole L of 2 x 2 without a quarter, whose middle is its inner corner;
    // one of 3 has its middle off a U.
    const Scene scene = SceneBuilder()
                            .quad({0, 0, 0}, {3, 0, 0}, {3, 0.5f, 0}, {0, 0.5f, 0})
                            .quad({0, 0.5f, 0}, {0.5f, 0.5f, 0}, {0.5f, 3, 0}, {0, 3, 0})
                            .quad({2.5f, 0.5f, 0}, {3, 0.5f, 0}, {3, 3, 0}, {2.5f, 3, 0})
                            .scene();
    for (const double width : {3.0, 2.0, 1.0, 0.7, 0.3}) {
        const SurfaceCells cells = divided(scene, width);
        EXPECT_NEAR(sumOfAreas(cells), 1.5 + 2 * 1.25, 1e-12);
        for (const Cell& cell : cells.cells)
            expectOnTriangle(cells, cell, 1e-12);
    }
}

TEST(SurfaceCells, JoinTurnedWallsInSpiteOfRounding) {
    // A turned wall's corners are rounded to floats, so that its triangles aren't quite coplanar.
    for (const double degrees : {7.0, 33.0, 71.3}) {
        const double c = std::cos(degrees * std::numbers::pi / 180.0),
                     s = std::sin(degrees * std::numbers::pi / 180.0);
        const auto at = [&](double along, double up) {
            return glm::vec3(200.0 + c * along, up, -300.0 + s * along);
        };
        SceneBuilder builder;
        for (int i = 0; i < 10; ++i)
            builder.quad(at(i + 1, 0), at(i, 0), at(i, 3), at(i + 1, 3));
        const SurfaceCells cells = divided(builder.scene(), 0.5);
        EXPECT_EQ(cells.cells.size(), 20u * 6u);
        EXPECT_EQ(std::set(cells.patchOf.begin(), cells.patchOf.end()).size(), 1u);
    }
}

TEST(SurfaceCells, KeepApartWhatBendsOrDiffersInMaterial) {
    // A box has six patches, a cylinder of 64 sides its 64.
    const SurfaceCells box = divided(SceneBuilder().box({0, 0, 0}, {1, 1, 1}).scene(), 1.0);
    EXPECT_EQ(box.cells.size(), 6u);
    SceneBuilder cylinder;
    const auto at = [](int i, float y) {
        const double angle = 2.0 * std::numbers::pi * i / 64.0;
        return glm::vec3(10.0 * std::cos(angle), y, 10.0 * std::sin(angle));
    };
    for (int i = 0; i < 64; ++i)
        cylinder.quad(at(i + 1, 0), at(i, 0), at(i, 1), at(i + 1, 1));
    EXPECT_EQ(divided(cylinder.scene(), 2.0).cells.size(), 64u);
    const SurfaceCells glazed = divided(SceneBuilder()
                                            .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
                                            .material(Material())
                                            .quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0})
                                            .scene(),
                                        2.0);
    EXPECT_EQ(glazed.cells.size(), 2u);
}

TEST(SurfaceCells, HaveTheAreaOfTheMesh) {
    std::mt19937 random(3);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        SceneBuilder soup;
        std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
        const auto point = [&] {
            return static_cast<float>(scale) *
                   glm::vec3(coordinate(random), coordinate(random), coordinate(random));
        };
        for (int i = 0; i < 50; ++i)
            soup.triangle(point(), point(), point());
        soup.triangle({0, 0, 0}, glm::vec3(scale, 0, 0),
                      glm::vec3(scale, 1e-5 * scale, 0)); // sliver
        soup.triangle({0, 0, 0}, {0, 0, 0}, {1, 0, 0});   // no area
        for (const double width : {0.07, 0.5, 10.0}) {
            const SurfaceCells cells = divided(soup.scene(), width * scale);
            const double area = areaOfMesh(cells);
            EXPECT_NEAR(sumOfAreas(cells), area, 1e-12 * area) << scale << " " << width;
            for (const Cell& cell : cells.cells) {
                expectOnTriangle(cells, cell, 1e-9 * scale);
                EXPECT_NEAR(areaOfFaces(cells, cell), cell.area, 1e-9 * area);
            }
        }
    }
}

TEST(SurfaceCells, OfAMirroredAndFarOffSceneFaceOutwards) {
    const glm::dmat4 far = glm::translate(glm::dmat4(1.0), glm::dvec3(4.5e6, 300.0, -5.4e6)) *
                           glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
    const SurfaceCells cells =
        divided(SceneBuilder().box({-1, -1, -1}, {1, 1, 1}).placedBy(far).scene(), 0.5);
    EXPECT_EQ(cells.cells.size(), 6u * 16u);
    EXPECT_NEAR(sumOfAreas(cells), 24.0, 1e-6);
    const glm::dvec3 middle(4.5e6, 300.0, -5.4e6);
    for (const Cell& cell : cells.cells)
        EXPECT_NEAR(glm::dot(cell.normal, cell.point - middle), 1.0, 1e-6);
}

TEST(SurfaceCells, StandOffByTheOffset) {
    const SurfaceCells cells = divided(SceneBuilder().floor(1).scene(), 1.0, 0.25);
    ASSERT_EQ(cells.cells.size(), 4u);
    for (const Cell& cell : cells.cells) {
        EXPECT_NEAR(cell.point.y, 0.25, 1e-15);
        EXPECT_NEAR(cells.footOf(cell).y, 0.0, 1e-15);
    }
}

TEST(SurfaceCells, TooManyAreRefusedBeforeTheyAreMade) {
    const Scene floor = SceneBuilder().floor(1000).scene();
    for (const double width : {0.01, 1e-9, 1e-300}) {
        try {
            divided(floor, width);
            FAIL() << width;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::usage);
            EXPECT_NE(std::string(error.what()).find("--grid"), std::string::npos) << error.what();
        }
    }
}

} // namespace edgeshade::hours
