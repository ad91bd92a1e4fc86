#pragma once

#include "src/city/job_result.hpp"
#include "src/city/plan_file.hpp"

#include <functional>

namespace edgeshade::city {

/// A row of a map, from the west.
struct MapRow {
    /// The number of sun positions that light each cell; `nothing` where there is no surface.
    std::span<const std::int32_t> lit;
    std::span<const std::uint16_t> months; ///< the plan's, as in JobResult
    std::span<const std::uint8_t> bits;    ///< the plan's, as in JobResult
};

/// Receives a map piece by piece.
struct MapVisitor {
    /// Each job once, before its first row.
    std::function<void(const JobResult& result)> job;
    /// Each source once, after all jobs that have cells on it.
    std::function<void(std::size_t source)> sourceEnd;
    /// Each row of the plan's region, from the north.
    std::function<void(const MapRow& row)> row;
};

/// Requires that a folder has the results of all jobs. Throws InputError naming the first that is
/// missing.
void requireAllThere(const Plan& plan, const std::filesystem::path& results);

/// Joins the results of all jobs, from a folder. Holds the results of jobs that one row crosses,
/// and no others; returns the most cells that these had. The order of jobs with the same northern
/// edge is the plan's.
///
/// Throws InputError naming the job or its file: the result is missing, invalid or of another plan.
std::size_t sweepMap(const ReadPlan& read, const std::filesystem::path& results,
                     const MapVisitor& visitor);

} // namespace edgeshade::city
