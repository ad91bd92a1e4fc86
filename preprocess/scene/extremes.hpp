#pragma once

namespace edgeshade {

// Limits of cameras and lights, in files and in a viewer's state.

/// Largest coordinate or length, in scene units; beyond it floats can't resolve the scene.
inline constexpr double farthestPlace = 1e12;
inline constexpr double smallestLength = 1e-12; ///< scene units
inline constexpr double brightestLight = 1e12;  ///< colour times intensity
inline constexpr double narrowestAngle = 1e-6;  ///< radians, of a cone or a field of view

} // namespace edgeshade
