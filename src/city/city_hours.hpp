#pragma once

#include "src/city/job_result.hpp"
#include "src/city/plan.hpp"

namespace edgeshade::city {

/// Value of a cell without a surface, among numbers of sun positions.
inline constexpr std::int32_t nothing = -1;

/// Hours that a sun position stands for.
inline double hoursOfPosition(const Plan& plan) {
    return static_cast<double>(plan.schedule.step.count()) / 60.0;
}

/// An object's cells, summed up.
struct ObjectHours {
    ResultObject object;
    std::size_t cells = 0;
    std::uint64_t litSum = 0; ///< of sun positions, over its cells
    std::uint16_t least = 0, most = 0;

    double meanLit() const { return static_cast<double>(litSum) / static_cast<double>(cells); }
};

/// The cells on surfaces of one kind, summed up.
struct KindHours {
    std::size_t cells = 0;
    std::uint64_t litSum = 0;
};

/// A whole map, summed up.
struct CityHours {
    std::size_t positions = 0; ///< of the sun
    std::size_t cells = 0;     ///< those with a surface
    std::uint64_t litSum = 0;  ///< of sun positions, over these
    std::uint16_t least = 0, most = 0;
    std::array<KindHours, 5> kinds{}; ///< by SurfaceKind
    std::size_t objects = 0, buildings = 0;
    std::size_t cellsHeld = 0; ///< the most that were in memory at once, while jobs were joined
};

} // namespace edgeshade::city
