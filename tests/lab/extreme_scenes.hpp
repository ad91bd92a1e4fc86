#pragma once

// The scenes of the table of extremes. All but the smallest stand on or over a floor at y = 0.

#include "src/scene/load.hpp"
#include "tests/support/scene_builder.hpp"

#include <functional>

namespace edgeshade::test {

/// Ready for drawing, with its shadow data.
LoadedScene loaded(Scene scene, bool castMasked = false);

/// The same, later.
std::function<LoadedScene()> later(const std::function<SceneBuilder()>& draw,
                                   bool castMasked = false);

/// The yard as flattening leaves what nodes turn and move: by ordinary numbers, and rounded.
glm::dmat4 ordinaryPlace();
LoadedScene turnedYard();

/// Triangles with a longest side `aspect` times their height: one alone, one within a sheet.
SceneBuilder sliver(float aspect);

/// `n` triangles around one upright edge.
SceneBuilder fan(int n);

/// Three triangles at one place; `opposite`: the second is turned over.
SceneBuilder duplicated(bool opposite);

/// A box, and triangles without area on its corners, edges and faces.
SceneBuilder boxWithDegenerateTriangles();

/// Quads of which one side meets two.
SceneBuilder tJunction();

/// A band with half a turn: one side, no orientation.
SceneBuilder moebiusStrip();

/// The figure-eight immersion of the Klein bottle: closed, one side, crosses itself in a circle.
SceneBuilder kleinBottle();

/// The upper half of a sphere, open below.
SceneBuilder hemisphere();

/// `count` sheets above one another.
SceneBuilder stack(int count);

/// Boxes and a sheet of 1e-3 around the origin, on a floor of 10.
SceneBuilder tinyYard();

/// Nodes of a glTF file with details of 1e-3 around `place`, on a slab of 10.
LoadedScene tinyBoxesAt(const glm::dvec3& place);

/// The yard, and something 1e-4 of its size before `eye`.
SceneBuilder yardBehindADot();

/// Cards with striped holes, MASK, that cast: holes by a texture, or by the alpha of vertices.
LoadedScene leavesByTexture();
LoadedScene leavesByVertexAlpha();

/// Hills on a grid of `cells` x `cells`, two triangles a cell, vertices shared.
LoadedScene hills(std::uint32_t cells);

} // namespace edgeshade::test
