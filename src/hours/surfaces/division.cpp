#include "src/hours/surfaces/division.hpp"

#include "src/hours/surfaces/patch_cells.hpp"

namespace edgeshade::hours {
namespace {

/// Share of a cell's width by which a patch may leave its plane.
constexpr double bendShare = 0.01;

} // namespace

SurfaceCells cellsOf(const Scene& scene, const SurfaceChoice& choice, const GridSettings& grid) {
    SurfaceCells cells;
    cells.offset = grid.offset;
    cells.triangles = worldTriangles(scene, choice);
    cells.patchOf.assign(cells.triangles.size(), SurfaceCells::none);
    std::uint32_t number = 0;
    for (const Patch& patch : patchesOf(scene, cells.triangles, bendShare * grid.width)) {
        for (const std::uint32_t triangle : patch.triangles)
            cells.patchOf[triangle] = number;
        ++number;
        addPatchCells(patch, grid, cells);
    }
    return cells;
}

} // namespace edgeshade::hours
