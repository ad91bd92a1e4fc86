#pragma once

#include "src/hours/positions.hpp"
#include "src/hours/surfaces/cells.hpp"
#include "src/hours/surfaces/sensor_light.hpp"

#include <array>
#include <functional>

namespace edgeshade::hours {

/// The measurement at each cell.
struct LightQuestion {
    std::span<const Position> positions{};
    std::chrono::minutes step{10};              ///< that each position stands for
    std::chrono::minutes offset{0};             ///< of the clock that months are counted by
    bool months = false;                        ///< counts by month too
    bool bits = false;                          ///< keeps every bit
    std::span<const double> normalIrradiance{}; ///< W/m² of the beam, by position; empty: none
};

/// The light of all cells, in their order. Vectors that weren't requested are empty.
struct CellLight {
    static constexpr std::uint32_t never = 0xFFFFFFFF;

    std::vector<std::uint32_t> lit;                    ///< number of positions that light the cell
    std::vector<std::uint32_t> first, last;            ///< of these positions; never: there is none
    std::vector<std::array<std::uint32_t, 12>> months; ///< number by month, January first
    std::vector<double> directKwh; ///< energy of the direct beam on the cell, kWh/m²
    /// Bits of a row for each cell, in whole bytes, the first position in the highest bit.
    std::vector<std::uint8_t> bits;
};

/// The sensors of cells [first, end).
std::vector<Sensor> sensorsOf(const SurfaceCells& cells, std::size_t first, std::size_t end);

/// Light of cells [first, end) from all positions.
using CellBits = std::function<rays::LitBits(std::size_t first, std::size_t end)>;

/// Measures all cells, those left out too. `onShare` is called with the share that is done. Memory
/// grows with the cells, and with the positions only for bits.
CellLight lightOf(const SurfaceCells& cells, const LightQuestion& question, const CellBits& bitsOf,
                  const std::function<void(double)>& onShare);

/// The same by light at sensors.
CellLight lightOf(const SurfaceCells& cells, const LightQuestion& question,
                  const SensorLight& light, const std::function<void(double)>& onShare);

} // namespace edgeshade::hours
