#pragma once

#include <string_view>

// Version of the headers, for #if. Release versions follow Semantic Versioning 2.0.0, for the
// promises of docs/versions.md.
#define EDGESHADE_VERSION_MAJOR 1
#define EDGESHADE_VERSION_MINOR 0
#define EDGESHADE_VERSION_PATCH 0

namespace edgeshade {

/// "major.minor.patch", as `edgeshade --version` prints it.
inline constexpr std::string_view versionText = "1.0.0";

/// Number of the packed format, "version" of the glTF extension EDGESHADE_shadow_volume. It counts
/// apart from the release version: it rises when the packed bytes of a scene change.
inline constexpr int packedFormatVersion = 2;

} // namespace edgeshade
