#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Gives every batch simplified casters: its opaque triangles, welded on exact positions, with as
/// many edges collapsed as meshoptimizer's error allows. Drawn surfaces stay unchanged.
///
/// `error`: scene units, >= 0; 0 simplifies nothing. It is the root mean square distance of a
/// vertex to the planes of the triangles it replaces, so that single points can be farther off, and
/// thinner parts may vanish. In a scaled batch its longest axis counts, at rest.
///
/// Collapsing an edge of welded triangles maps the whole mesh, so that closed parts stay closed.
/// Borders may move along themselves, weighted ten times as much as surfaces. Locked borders would
/// keep every vertex of leaves, and of glTF primitives that meet without sharing positions.
void simplifyCasters(Scene& scene, double error);

} // namespace edgeshade
