#pragma once

// The scenes of the table of extremes. All but the smallest are on or over a floor at y = 0.

#include "src/scene/load.hpp"
#include "tests/support/scene_builder.hpp"

#include <functional>

namespace edgeshade::test {

/// The scene ready for drawing, with its shadow data.
LoadedScene loaded(Scene scene, bool castMasked = false);

/// The same, created only when called.
std::function<LoadedScene()> later(const std::function<SceneBuilder()>& draw,
                                   bool castMasked = false);

/// The yard as flattened from nodes that rotate and move it by ordinary numbers, and rounded.
glm::dmat4 ordinaryPlace();
LoadedScene turnedYard();

/// Triangles whose longest side is `aspect` times their height: one alone, one within a sheet.
SceneBuilder sliver(float aspect);

/// `n` triangles around one upright edge.
SceneBuilder fan(int n);

/// Three triangles in one place; `opposite`: the second is turned over.
SceneBuilder duplicated(bool opposite);

/// A box, and triangles without area on its corners, edges and faces.
SceneBuilder boxWithDegenerateTriangles();

/// Quads, one side of which meets two.
SceneBuilder tJunction();

/// A band with half a twist: one side, no orientation.
SceneBuilder moebiusStrip();

/// The figure-eight immersion of the Klein bottle: closed, one-sided, crossing itself in a circle.
SceneBuilder kleinBottle();

/// The upper half of a sphere, open below.
SceneBuilder hemisphere();

/// `count` sheets above one another.
SceneBuilder stack(int count);

/// Boxes and a sheet of 1e-3 around the origin, on a floor of 10.
SceneBuilder tinyYard();

/// Nodes of a glTF file with details of 1e-3 around `place`, on a slab of 10.
LoadedScene tinyBoxesAt(const glm::dvec3& place);

/// The yard, and an object of 1e-4 of its size in front of `eye`.
SceneBuilder yardBehindADot();

/// MASK cards with striped holes that cast: holes by a texture, or by the vertices' alpha.
LoadedScene leavesByTexture();
LoadedScene leavesByVertexAlpha();

/// Hills on a grid of `cells` x `cells`, two triangles a cell, with shared vertices.
LoadedScene hills(std::uint32_t cells);

} // namespace edgeshade::test
