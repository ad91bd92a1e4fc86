#pragma once

#include "src/environment/environment.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace edgeshade {

/// How bright an environment is that was read.
enum class EnvironmentScale {
    meanOne,  ///< mean luminance 1 over all directions, as the neutral one's
    asStored, ///< what the file has
};

/// Reads an equirectangular Radiance picture (.hdr) of at most 16384 x 16384; Panorama says where
/// it looks. Safe on untrusted input; the same bytes, the same environment. Reflections are cut off
/// at largestEncodedRadiance. Throws InputError.
Environment readEnvironment(const std::filesystem::path& path,
                            EnvironmentScale scale = EnvironmentScale::meanOne);

/// The same of a file in memory. `name` is for messages.
Environment readEnvironment(std::span<const std::uint8_t> bytes, const std::string& name,
                            EnvironmentScale scale = EnvironmentScale::meanOne);

} // namespace edgeshade
