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

/// Whether it finds casters that are wholly in the shadow of others beside drawing.
inline constexpr bool cullsMeanwhile = !isForPages;

/// Whether it counts volumes around what is visible of their shadows alone: pages can't read depth.
inline constexpr bool readsDepth = !isForPages;

/// Whether surfaces that a light grazes are marked dark: in pages no one looks at bare masks.
inline constexpr bool marksGrazed = !isForPages;

/// Whether it may keep the colours that ambient light leaves: pages are mostly drawn by GPUs.
inline constexpr bool keepsAmbient = !isForPages;

/// Whether it can leave out backs of solids.
inline constexpr bool mayCullSolids = !isForPages;

} // namespace edgeshade
