#pragma once

#include "src/hours/positions.hpp"

namespace edgeshade::hours {

/// Sun positions that 16-bit counts hold.
inline constexpr std::size_t mostPositions = 65535;

/// When the sun is asked for, over which place. Each day's clock hours are cut into intervals of
/// one step, and the sun's position at the middle of an interval stands for all of it.
struct Schedule {
    sun::Place place;
    std::chrono::minutes offset{0};       ///< the clock's, east of Greenwich is positive
    std::chrono::sys_days from{};         ///< the first day of that clock
    std::chrono::sys_days to{};           ///< the last one, not before `from`
    std::chrono::minutes step{10};        ///< divides opens to closes
    std::chrono::minutes opens{0};        ///< since 0:00; 0 <= opens < closes
    std::chrono::minutes closes{24 * 60}; ///< at most 24:00
    double minAltitude = 0.0;             ///< degrees, refracted: the sun counts above it
    double north = 0.0;                   ///< as sun::towardsSun() has it

    std::size_t days() const { return static_cast<std::size_t>((to - from).count()) + 1; }
};

/// The offset of a clock that has noon near the sun's: whole hours, nearest to longitude / 15.
std::chrono::minutes offsetNear(double longitude);

/// All intervals in whose middle the sun is above the altitude, in order of time; none where it
/// never is. Throws Error(usage) that names the option: days the wrong way round, a step that
/// doesn't divide the clock hours, hours the wrong way round, more than mostPositions.
std::vector<Position> positionsOf(const Schedule& schedule);

} // namespace edgeshade::hours
