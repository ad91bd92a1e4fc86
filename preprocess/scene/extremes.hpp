#pragma once

namespace edgeshade {

// What cameras and lights may be, in files and in a viewer's state.

/// Of a coordinate or a length, in scene units; beyond it floats lose the scene.
inline constexpr double farthestPlace = 1e12;
inline constexpr double smallestLength = 1e-12; ///< likewise
inline constexpr double brightestLight = 1e12;  ///< colour times intensity
inline constexpr double narrowestAngle = 1e-6;  ///< radians, of a cone or a field of view

} // namespace edgeshade
