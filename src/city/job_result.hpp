#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/city/cell_grid.hpp"
#include "src/city/city_tile.hpp"

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
    std::vector<ResultObject> named; ///< in the order of the first cell that each has
};

/// "job-12.city", beside the others.
std::string fileNameOfJob(std::size_t job);

/// The same result gives the same bytes.
Bytes bytesOfResult(const JobResult& result);

/// Reads a result. Safe on untrusted input. Throws InputError naming the path.
JobResult resultFrom(const std::filesystem::path& path);

} // namespace edgeshade::city
