#pragma once

namespace edgeshade {

/// Whether this build has all kinds and filters of shadow maps, or cubes, single maps and PCF
/// alone, which is what a page's weight has room for.
#ifdef EDGESHADE_PLAIN_MAPS
inline constexpr bool allMapKinds = false;
#else
inline constexpr bool allMapKinds = true;
#endif

} // namespace edgeshade
