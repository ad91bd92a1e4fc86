#pragma once

#include "tests/support/tiny_meshes.hpp"

#include <cstddef>
#include <string>

namespace edgeshade::test {

// Meshes of about the requested number of triangles, the same on every platform.

/// A square of hills, made by raising the vertices of a regular grid: most edges bend.
Soup hillyGrid(std::size_t triangles);

/// Closed boxes, axis-aligned, that don't touch: an assembly of many flat parts, each face with its
/// own vertices.
Soup manyBoxes(std::size_t triangles);

/// Random triangles over a quarter as many points of a lattice, some repeated or without area:
/// edges have any number of triangles, in either direction.
Soup tangle(std::size_t triangles);

/// Kinds: "grid", "boxes", "tangle". Throws std::invalid_argument for another name.
Soup generatedMesh(const std::string& kind, std::size_t triangles);

} // namespace edgeshade::test
