#pragma once

#include "src/hours/surfaces/cell_light.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace edgeshade::hours {

/// A run over all chosen surfaces: everything that its files and reports are made from.
struct SurfaceRun {
    nlohmann::ordered_json settings; ///< as in reports; includes those that HoursSettings reads
    std::string scene;               ///< a hash of all casters and surfaces, 16 digits
    std::string version;             ///< of the program
    nlohmann::ordered_json files;    ///< [{"name", "sha256"}]: the scene's, as they are on disk
    std::vector<std::string> warnings;
    std::vector<Position> positions;
    std::chrono::minutes step{10};  ///< that each position stands for
    std::chrono::minutes offset{0}; ///< of the clock
    double unit = 1.0;              ///< metres that a scene unit is
    bool ofWindows = false;         ///< each cell is a window; light has bits
    SurfaceCells cells;
    CellLight light;
    std::map<std::uint32_t, std::string> nodes, materials; ///< names, by index in the file

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
