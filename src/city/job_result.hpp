#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/city/cell_grid.hpp"
#include "src/city/city_tile.hpp"
#include "src/hours/positions.hpp"

#include <filesystem>

namespace edgeshade::city {

/// An object of a source, as results name it.
struct ResultObject {
    std::size_t source = 0; ///< in Plan::sources
    std::string id;
    bool isBuilding = false;
};

/// The findings of a job, cell by cell, row by row from the south.
struct JobResult {
    std::string plan;    ///< the hash of the plan's file
    std::size_t job = 0; ///< from 1
    CellRange cells;
    std::size_t positions = 0;          ///< of the sun, at most 65535
    std::vector<std::uint16_t> lit;     ///< number of positions that light the cell
    std::vector<std::uint32_t> objects; ///< in `named`; noSurface: nothing is there
    std::vector<SurfaceKind> kinds;
    /// Number of positions of each month that light the cell, January first, 12 a cell; may be
    /// empty.
    std::vector<std::uint16_t> months;
    /// Bits of positions, the first in a byte's highest bit, in bytesOfRow() bytes a cell; may be
    /// empty.
    Bytes bits;
    std::vector<ResultObject> named; ///< in the order of the first cell that each has
};

inline constexpr std::size_t monthsOfYear = 12;

/// Bytes of a cell in a result, before it is deflated.
std::size_t bytesOfCell(bool months, bool bits, std::size_t positions);
/// The most bytes of all cells of a result.
inline constexpr std::uint64_t mostBytesOfCells = std::uint64_t{1} << 30;

/// "job-12.city", beside the others.
std::string fileNameOfJob(std::size_t job);

/// The same result gives the same bytes.
Bytes bytesOfResult(const JobResult& result);

/// Reads a result. Safe on untrusted input. Throws InputError naming the path.
JobResult resultFrom(const std::filesystem::path& path);

} // namespace edgeshade::city
