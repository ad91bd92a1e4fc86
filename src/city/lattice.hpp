#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade::city {

/// Distance between points of the lattice that all corners and cells lie on, in metres: a power of
/// two, about a millimetre. Differences of lattice points are exact in double, and in float where
/// they are below 2^24 units, so that no local origin changes any answer (docs/method.md, C63).
inline constexpr double latticeUnit = 0x1p-10;

/// Coordinates up to which a city may reach, in metres; beyond it lattice units don't fit.
inline constexpr double farthestCoordinate = 0x1p29;
/// The same for heights, and the longest side of the box around a triangle: up to these the
/// integers that compare heights fit into 128 bits.
inline constexpr double farthestHeight = 0x1p14;
inline constexpr double longestTriangle = 0x1p13;

/// The nearest point of the lattice; no -0.
inline double onLattice(double value) {
    return std::round(value / latticeUnit) * latticeUnit + 0.0;
}
inline glm::dvec3 onLattice(const glm::dvec3& point) {
    return {onLattice(point.x), onLattice(point.y), onLattice(point.z)};
}

/// A lattice coordinate in units.
inline std::int64_t unitsOf(double onLattice) {
    return static_cast<std::int64_t>(onLattice / latticeUnit);
}

} // namespace edgeshade::city
