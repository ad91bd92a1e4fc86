#pragma once

#include "tests/support/gltf_builder.hpp"

namespace edgeshade::test {

// Deforming scenes, authored in code: about 2 high, on a floor, with a post beside them.

/// A figure of six capsules on eleven joints, with 12 * `sides` * `rings` triangles, sides >= 3,
/// rings >= 2. Its animations: "walk" (1 s, linear, hips on a cubic spline), "wave" (2 s, cubic
/// splines), "jump" (1 s, steps).
GltfBuilder walkingFigure(int sides, int rings);

/// A ball of 2 * `sides` * `rings` triangles with three morph targets: a spike, a twist, and one
/// that turns it inside out; beside it a flag without normals. Its animations: "morph" (2 s,
/// linear), "splines" (2 s).
GltfBuilder morphingBall(int sides, int rings);

} // namespace edgeshade::test
