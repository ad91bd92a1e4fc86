#pragma once

#include <cstddef>

namespace edgeshade {

/// How to keep a mesh that stands at several places: once for all, with a batch for each place, or
/// repeated for each place, in the batch that moves with it.
enum class InstanceChoice {
    automatic, ///< once if sharingPays()
    shared,    ///< once
    repeated,  ///< again for each
};

/// "auto", "shared", "repeated".
const char* nameOf(InstanceChoice choice);

/// Whether a mesh of `triangles` triangles at `places` places is worth keeping once. A copy costs
/// memory, and time to build its records. A batch costs every frame its own plan and its own draws,
/// as much as a few hundred more triangles in an existing batch (docs/measured/instances.md).
bool sharingPays(InstanceChoice choice, std::size_t triangles, std::size_t places);

} // namespace edgeshade
