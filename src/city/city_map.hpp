#pragma once

#include "src/city/job_result.hpp"
#include "src/city/plan_file.hpp"

namespace edgeshade::city {

/// An object's cells, summed up.
struct ObjectHours {
    ResultObject object;
    std::size_t cells = 0;
    std::uint64_t litSum = 0; ///< of sun positions, over its cells
    std::uint16_t least = 0, most = 0;
};

/// The cells on surfaces of one kind, summed up.
struct KindHours {
    std::size_t cells = 0;
    std::uint64_t litSum = 0;
};

/// All jobs of a plan in one.
struct CityMap {
    CellRange region;
    std::size_t positions = 0;
    /// Number of sun positions that light each cell, row by row from the north; `nothing`: there is
    /// no surface.
    std::vector<std::int32_t> lit;
    static constexpr std::int32_t nothing = -1;
    std::vector<ObjectHours> objects; ///< by source and name
    std::array<KindHours, 5> kinds{}; ///< by SurfaceKind
    double hoursOfPosition = 0.0;     ///< hours that a position stands for

    double hoursOf(std::int32_t count) const { return count * hoursOfPosition; }
    double meanHoursOf(const ObjectHours& object) const {
        return hoursOfPosition * static_cast<double>(object.litSum) /
               static_cast<double>(object.cells);
    }
};

/// Joins the results of all jobs, in their order, from a folder. Throws InputError naming the job:
/// its result is missing, or is of another plan.
CityMap mapOf(const ReadPlan& read, const std::filesystem::path& results);

} // namespace edgeshade::city
