#pragma once

namespace edgeshade {

/// Whether this is a build for web pages, which leave out parts to save size.
#ifdef EDGESHADE_FOR_PAGES
inline constexpr bool isForPages = true;
#else
inline constexpr bool isForPages = false;
#endif

/// Whether batches keep their geometry, for casters that the processor cuts.
inline constexpr bool keepsGeometry = !isForPages;

/// Whether it lists lights by tile.
inline constexpr bool listsLights = !isForPages;

/// Whether it ranks lights by importance; otherwise the first ones matter most.
inline constexpr bool weighsLights = !isForPages;

/// Whether it can test visible points for shadow, where the processor renders: pages have no
/// triangle numbers.
inline constexpr bool hasPoints = !isForPages;

/// Whether surfaces that a light grazes are marked dark: in pages nobody looks at bare masks.
inline constexpr bool marksGrazed = !isForPages;

} // namespace edgeshade
