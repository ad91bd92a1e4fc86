#pragma once

namespace edgeshade {

/// Whether this build has brute-force volumes and planar shadows, which are there to be compared
/// with, and for which a page's weight has no room.
#ifdef EDGESHADE_WITHOUT_RIVALS
inline constexpr bool hasRivals = false;
#else
inline constexpr bool hasRivals = true;
#endif

} // namespace edgeshade
