#pragma once

#include "src/city/plan.hpp"
#include "src/city/source_list.hpp"

#include <functional>

namespace edgeshade::city {

struct PlanChoice {
    SourceReading reading;
    hours::Schedule schedule;
    bool placeFromSources = false; ///< fills the schedule's place and north
    /// The clock's offset from UTC; null: by the place.
    std::optional<std::chrono::minutes> offset;
    double grid = 1.0;
    bool months = false, bits = false;             ///< as in Plan
    std::uint64_t memory = std::uint64_t{4} << 30; ///< bytes that a job may take
    std::size_t tiles = 1;                         ///< the least number of targets
};

/// Reads every source once, one after the other, and divides the ground below them into targets:
/// squares of a power of two of cells, aligned to the world's axes, that are divided until a job
/// fits into the memory. `progress` gets the share done and the source; `warnings` the sources'.
///
/// Throws InputError: a source is invalid, two have one building or rasters that overlap, or
/// different EPSG codes. Throws Error(usage): no EPSG code tells the place. Throws
/// Error(unavailable): a job can't be made small enough.
Plan planOf(const SourceList& list, const PlanChoice& choice,
            const std::function<void(double, const std::string&)>& progress,
            std::vector<std::string>& warnings);

} // namespace edgeshade::city
