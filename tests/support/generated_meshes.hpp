#pragma once

#include "tests/support/tiny_meshes.hpp"

#include <cstddef>
#include <string>

namespace edgeshade::test {

// Meshes of about as many triangles as are asked for, the same on every platform.

/// A square of hills, each a vertex of a regular grid moved up: most edges bend.
Soup hillyGrid(std::size_t triangles);

/// Closed boxes that don't touch, turned by nothing: an assembly of many flat parts, each face with
/// vertices of its own.
Soup manyBoxes(std::size_t triangles);

/// Random triangles over a quarter as many points of a lattice, some of them repeated or without
/// area: edges of any number of triangles, running any way.
Soup tangle(std::size_t triangles);

/// "grid", "boxes", "tangle". Throws std::invalid_argument for another name.
Soup generatedMesh(const std::string& kind, std::size_t triangles);

} // namespace edgeshade::test
