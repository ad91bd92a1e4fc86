#pragma once

#include <cstddef>

namespace edgeshade {

/// How a mesh is kept that stands at several places: once for all of them, a batch each, or again
/// for each, in the batch of what moves it.
enum class InstanceChoice {
    automatic, ///< once where sharingPays()
    shared,    ///< once
    repeated,  ///< again for each
};

/// "auto", "shared", "repeated".
const char* nameOf(InstanceChoice choice);

/// Whether a mesh of so many triangles that stands at so many places is worth keeping once. A copy
/// costs memory and time to build its records; a batch costs every frame its own plan and its own
/// draws, as much as some hundred triangles more in a batch that is there anyway
/// (docs/measured/instances.md).
bool sharingPays(InstanceChoice choice, std::size_t triangles, std::size_t places);

} // namespace edgeshade
