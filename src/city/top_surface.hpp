#pragma once

#include "src/city/cell_grid.hpp"
#include "src/city/city_tile.hpp"

#include <span>
#include <vector>

namespace edgeshade::city {

/// Value where nothing is below a cell's middle.
inline constexpr std::uint32_t noSurface = 0xFFFFFFFF;

/// For each cell, row by row from the south, the triangle that a vertical line from above through
/// its middle meets first, without rounding (docs/method.md, C63). Where several meet it at one
/// height, their corners decide, not their order. Vertical triangles are never met.
std::vector<std::uint32_t> topSurfaces(std::span<const CityTriangle> triangles,
                                       const CellRange& cells, double width);

/// The height of a triangle's plane over a point that it holds, in metres, rounded.
double heightAt(const CityTriangle& triangle, double x, double y);

} // namespace edgeshade::city
