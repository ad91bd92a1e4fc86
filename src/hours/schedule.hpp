#pragma once

#include "src/hours/positions.hpp"

namespace edgeshade::hours {

/// The most sun positions that 16-bit counts hold.
inline constexpr std::size_t mostPositions = 65535;

/// Times and place of a run's sun positions. Each day's clock hours are divided into intervals of
/// one step, and the sun's position at the middle of an interval stands for all of it.
struct Schedule {
    sun::Place place;
    std::chrono::minutes offset{0};       ///< offset of the clock, positive east of Greenwich
    std::chrono::sys_days from{};         ///< first day, on that clock
    std::chrono::sys_days to{};           ///< last day, not before `from`
    std::chrono::minutes step{10};        ///< divides the time from opens to closes
    std::chrono::minutes opens{0};        ///< since 0:00; 0 <= opens < closes
    std::chrono::minutes closes{24 * 60}; ///< at most 24:00
    double minAltitude = 0.0;             ///< degrees, refracted: the sun counts above it
    double north = 0.0;                   ///< as for sun::towardsSun()

    std::size_t days() const { return static_cast<std::size_t>((to - from).count()) + 1; }
};

/// The offset of a clock whose noon is near the sun's: whole hours, nearest to longitude / 15.
std::chrono::minutes offsetNear(double longitude);

/// All intervals in whose middle the sun is above the altitude, in order of time; empty if it never
/// is. Throws Error(usage) naming the option: days or hours in the wrong order, a step that doesn't
/// divide the clock hours, or more than mostPositions.
std::vector<Position> positionsOf(const Schedule& schedule);

} // namespace edgeshade::hours
