#include "src/hours/surfaces/left_out_cells.hpp"

#include "src/hours/surfaces/division.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using test::SceneBuilder;

SurfaceCells marked(const Scene& scene, double width) {
    SurfaceCells cells =
        cellsOf(scene, [](std::uint32_t, std::uint32_t) { return true; }, {width, 0.0});
    markLeftOut(cells, solidSurfaces(scene, false));
    return cells;
}

std::size_t countOf(const SurfaceCells& cells, CellState state) {
    return static_cast<std::size_t>(std::ranges::count(cells.cells, state, &Cell::state));
}

} // namespace

TEST(LeftOutCells, OfAFloorAreThoseBeneathAHouse) {
    // A floor of 8 x 8 under a house of 4 x 4; the house's underside lies on a sheet, in no solid.
    const SurfaceCells cells =
        marked(SceneBuilder().floor(4).box({-2, 0, -2}, {2, 3, 2}).scene(), 1.0);
    for (const Cell& cell : cells.cells) {
        const bool beneath = cell.point.y == 0.0 && cell.normal.y > 0.0 &&
                             std::max(std::abs(cell.point.x), std::abs(cell.point.z)) < 2.0;
        EXPECT_EQ(cell.state == CellState::inside, beneath);
    }
    EXPECT_EQ(countOf(cells, CellState::inside), 16u);
    EXPECT_EQ(countOf(cells, CellState::within), 0u);
}

TEST(LeftOutCells, AreThoseOfSolidsThatTouchOrEnterEachOther) {
    // Two unit cubes side by side hide a face of each other. A third, half in the first, hides
    // half of four of its faces there.
    const SurfaceCells touching =
        marked(SceneBuilder().box({0, 0, 0}, {1, 1, 1}).box({1, 0, 0}, {2, 1, 1}).scene(), 0.25);
    EXPECT_EQ(countOf(touching, CellState::inside), 2u * 16u);
    const SurfaceCells entering =
        marked(SceneBuilder().box({0, 0, 0}, {4, 4, 4}).box({3, 1, 1}, {5, 3, 3}).scene(), 0.5);
    // The small box: its left face, and half of four faces. The large box: what is in the small.
    EXPECT_EQ(countOf(entering, CellState::inside), 16u + 4u * 8u + 16u);
}

TEST(LeftOutCells, OfRoomsAreNone) {
    // A hollow house: its inner surface is wound the other way, and encloses a room.
    SceneBuilder house;
    house.box({0, 0, 0}, {6, 4, 6});
    Scene scene = house.scene();
    Geometry& geometry = scene.batches[0].geometry.edit();
    const std::size_t outer = geometry.positions.size();
    for (std::size_t i = 0; i < outer; i += 3) {
        for (const std::size_t corner : {0u, 2u, 1u}) {
            geometry.indices.push_back(static_cast<std::uint32_t>(geometry.positions.size()));
            geometry.positions.push_back(0.5f + 0.8f * geometry.positions[i + corner]);
            geometry.normals.push_back(-geometry.normals[i]);
            geometry.texcoords.emplace_back(0.0f);
            geometry.colors.emplace_back(1.0f);
        }
    }
    geometry.groups.back().indexCount *= 2;
    EXPECT_EQ(countOf(marked(scene, 0.5), CellState::counted), marked(scene, 0.5).cells.size());
}

TEST(LeftOutCells, OfSolidsWoundInwardsAreAll) {
    Scene scene = SceneBuilder().box({0, 0, 0}, {1, 1, 1}).scene();
    Geometry& geometry = scene.batches[0].geometry.edit();
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3)
        std::swap(geometry.indices[i], geometry.indices[i + 1]);
    const SurfaceCells cells = marked(scene, 0.5);
    EXPECT_EQ(countOf(cells, CellState::inside), cells.cells.size());
}

TEST(LeftOutCells, OfASurfaceTwiceAreTheSecondOnes) {
    // The same wall twice, once divided along the other diagonal; the back is another surface.
    const SurfaceCells cells = marked(SceneBuilder()
                                          .quad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0})
                                          .quad({2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0})
                                          .quad({2, 0, 0}, {0, 0, 0}, {0, 2, 0}, {2, 2, 0})
                                          .scene(),
                                      0.5);
    ASSERT_EQ(cells.cells.size(), 48u);
    EXPECT_EQ(countOf(cells, CellState::within), 16u);
    for (std::size_t i = 0; i < 48; ++i)
        EXPECT_EQ(cells.cells[i].state == CellState::within, i / 16 == 1);
}

TEST(LeftOutCells, OfNeighboursInOnePlaneAreNone) {
    // Panels side by side in a turned plane, of two materials: patches of their own.
    SceneBuilder panels;
    for (int i = 0; i < 6; ++i) {
        const glm::vec3 along(0.83f, 0.0f, 0.31f), up(0.1f, 1.0f, 0.0f);
        const glm::vec3 from = 100.0f * up + static_cast<float>(i) * along;
        if (i == 3) panels.material(Material());
        panels.quad(from + along, from, from + up, from + along + up);
    }
    EXPECT_EQ(countOf(marked(panels.scene(), 0.1), CellState::within), 0u);
}

} // namespace edgeshade::hours
