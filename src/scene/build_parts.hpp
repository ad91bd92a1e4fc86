#pragma once

namespace edgeshade {

/// Pages leave out what their weight has no room for.
#ifdef EDGESHADE_FOR_PAGES
inline constexpr bool isForPages = true;
#else
inline constexpr bool isForPages = false;
#endif

/// Whether batches keep what they were uploaded of, for casters that the processor cuts.
inline constexpr bool keepsGeometry = !isForPages;

/// Whether it lists lights by tile.
inline constexpr bool listsLights = !isForPages;

/// Whether it weighs lights against each other, or takes the first to matter most.
inline constexpr bool weighsLights = !isForPages;

/// Whether it can ask visible points, where the processor draws: pages know no triangles' numbers.
inline constexpr bool hasPoints = !isForPages;

/// Whether surfaces that a light grazes are marked dark: in pages no one looks at bare masks.
inline constexpr bool marksGrazed = !isForPages;

} // namespace edgeshade
