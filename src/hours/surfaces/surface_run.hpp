#pragma once

#include "src/hours/run_head.hpp"
#include "src/hours/surfaces/cell_light.hpp"

namespace edgeshade::hours {

/// A run over all chosen surfaces: everything that its files and reports are made from.
struct SurfaceRun : RunHead {
    std::string version;           ///< of the program
    nlohmann::ordered_json files;  ///< [{"name", "sha256"}]: the scene's, as they are on disk
    std::chrono::minutes step{10}; ///< that each position stands for
    double unit = 1.0;             ///< metres that a scene unit is
    bool ofWindows = false;        ///< each cell is a window; light has bits
    SurfaceCells cells;
    CellLight light;

    /// Square metres of a cell.
    double areaOf(std::size_t cell) const { return cells.cells[cell].area * unit * unit; }
    double hoursOf(std::size_t cell) const {
        return static_cast<double>(light.lit[cell]) * static_cast<double>(step.count()) / 60.0;
    }
    double possibleHours() const {
        return static_cast<double>(positions.size()) * static_cast<double>(step.count()) / 60.0;
    }
    bool isCounted(std::size_t cell) const { return cells.cells[cell].state == CellState::counted; }
};

/// The measurement of a run's positions. `days`: of the run; `beam`: W/m² by position, empty: none.
/// Keeps every bit if `bits`, and for windows.
LightQuestion questionOf(const SurfaceRun& run, std::size_t days, std::span<const double> beam,
                         bool bits);

} // namespace edgeshade::hours
