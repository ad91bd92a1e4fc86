#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Gives every batch simplified casters: its opaque triangles, welded on exact positions, with as
/// many edges collapsed as meshoptimizer's error allows. What is drawn stays as it is.
///
/// `error`: scene units, >= 0; 0 simplifies nothing. It is the root of the mean squared distance to
/// the planes of the triangles that a vertex stands for, so single points can lie farther off, and
/// what is thinner may vanish. Where a batch is scaled, its longest axis counts, at rest.
///
/// Collapsing an edge of welded triangles maps the whole mesh, so what was closed stays closed.
/// Borders may move along themselves, weighed ten times as much as surfaces: locked ones would keep
/// every vertex of leaves and of glTF primitives that meet without sharing positions.
void simplifyCasters(Scene& scene, double error);

} // namespace edgeshade
