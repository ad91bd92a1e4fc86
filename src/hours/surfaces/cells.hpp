#pragma once

#include "src/hours/surfaces/patches.hpp"

#include <optional>

namespace edgeshade::hours {

/// Why a cell is left out of shares.
enum class CellState : std::uint8_t {
    counted,
    inside, ///< within a solid
    within, ///< on another cell's surface, which faces the same way
};

/// A cell of a patch's grid, with the part of the patch that it holds, and its sensor.
struct Cell {
    glm::dvec3 point{0.0};       ///< the sensor, on its triangle or off it, in the world
    glm::dvec3 normal{0.0};      ///< of that triangle, of length 1
    double area = 0.0;           ///< of the part, in scene units squared
    std::uint32_t triangle = 0;  ///< that the sensor is on
    std::uint32_t firstFace = 0; ///< of its part, in SurfaceCells::faces
    std::uint32_t faceCount = 0; ///< 1 or more
    CellState state = CellState::counted;
};

/// A convex polygon in the world, counter-clockwise as seen from its front.
struct CellFace {
    std::uint32_t firstCorner = 0; ///< in SurfaceCells::corners
    std::uint32_t cornerCount = 0; ///< 3 or more
};

/// The cells of a scene's surfaces.
struct SurfaceCells {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::vector<WorldTriangle> triangles;
    std::vector<std::uint32_t> patchOf; ///< number of each triangle's patch; none: it has no area
    std::vector<Cell> cells;            ///< patch after patch, in rows
    std::vector<CellFace> faces;
    std::vector<glm::dvec3> corners;
    double offset = 0.0; ///< of sensors from their triangles

    const WorldTriangle& triangleOf(const Cell& cell) const { return triangles[cell.triangle]; }
    /// The point of its triangle that the sensor is over.
    glm::dvec3 footOf(const Cell& cell) const { return cell.point - offset * cell.normal; }
};

/// The most cells of one run.
inline constexpr std::size_t mostCells = 10'000'000;

struct GridSettings {
    /// The most that a cell is wide and high, but for a thousandth; in scene units, above 0.
    double width = 0.5;
    double offset = 0.0; ///< of sensors from their triangles, along the normal; 0 or more
    /// Height of sensors over their cells' lower edges, above 0, as far as the cell is so high;
    /// null or on level patches: in the middle.
    std::optional<double> rise = {};
};

} // namespace edgeshade::hours
