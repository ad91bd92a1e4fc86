#pragma once

namespace edgeshade {

/// Pages leave out what their weight has no room for.
#ifdef EDGESHADE_FOR_PAGES
inline constexpr bool isForPages = true;
#else
inline constexpr bool isForPages = false;
#endif

/// Whether this build has all kinds and filters of shadow maps, or cubes, single maps and PCF
/// alone.
inline constexpr bool allMapKinds = !isForPages;

/// Whether it has brute-force volumes and planar shadows, which are there to be compared with.
inline constexpr bool hasRivals = !isForPages;

/// Whether it lists lights by tile.
inline constexpr bool listsLights = !isForPages;

/// Whether it weighs lights against each other, or takes the first to matter most.
inline constexpr bool weighsLights = !isForPages;

/// Whether it can ask visible points, where the processor draws: pages know no triangles' numbers.
inline constexpr bool hasPoints = !isForPages;

/// Whether surfaces that a light grazes are marked dark: in pages no one looks at bare masks.
inline constexpr bool marksGrazed = !isForPages;

} // namespace edgeshade
