#pragma once

#include "src/city/cell_grid.hpp"
#include "src/city/source.hpp"
#include "src/hours/schedule.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade::city {

/// A source with what its first reading found.
struct PlannedSource {
    Source source;
    std::uint64_t bytes = 0;
    std::string sha256;
    std::uint64_t triangles = 0;
    Box box; ///< of its triangles; empty: it has none
};

/// A target and the sources that its cells depend on.
struct Job {
    CellRange cells;
    double lowest = 0.0;              ///< no surface over the target is lower, in metres
    std::vector<std::size_t> sources; ///< in Plan::sources, ascending
    std::uint64_t memory = 0;         ///< bytes that it takes at most, by estimate
};

/// A whole computation, in jobs that know nothing of each other.
struct Plan {
    std::filesystem::path folder; ///< of the sources
    SourceReading reading;
    std::vector<PlannedSource> sources;
    std::optional<int> epsg;  ///< code of the frame's coordinates
    hours::Schedule schedule; ///< north: of the frame's grid
    double grid = 1.0;        ///< width of a cell, in metres
    bool months = false;      ///< counts by month too
    bool bits = false;        ///< which positions light a cell, too
    CellRange region;         ///< that holds all jobs
    std::vector<Job> jobs;
};

/// Towards the sun, in the frame: east, north, up.
inline glm::dvec3 inFrame(const glm::dvec3& sun) {
    return {sun.x, -sun.z, sun.y};
}

} // namespace edgeshade::city
