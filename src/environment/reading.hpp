#pragma once

#include "src/environment/environment.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace edgeshade {

/// Brightness of an environment that is read.
enum class EnvironmentScale {
    meanOne,  ///< mean luminance 1 over all directions, like the neutral one
    asStored, ///< unchanged from the file
};

/// Reads an equirectangular Radiance picture (.hdr) of at most 16384 x 16384; Panorama defines its
/// orientation. Safe on untrusted input; the same bytes give the same environment. Reflections are
/// clamped to largestEncodedRadiance. Throws InputError.
Environment readEnvironment(const std::filesystem::path& path,
                            EnvironmentScale scale = EnvironmentScale::meanOne);

/// As above for a file in memory. `name` is for messages.
Environment readEnvironment(std::span<const std::uint8_t> bytes, const std::string& name,
                            EnvironmentScale scale = EnvironmentScale::meanOne);

} // namespace edgeshade
