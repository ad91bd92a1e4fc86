#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Computes the vertices of a deforming batch for a shape, with their normals and tangents: morph
/// targets first, then joints, in double precision, rounded once. Returns false if a position does
/// not fit into a float; the batch then stays as it was.
bool poseBatch(Batch& batch, const BatchShape& shape);

/// For each vertex of a deforming batch, the first vertex that coincides with it in every pose.
std::vector<std::uint32_t> alikeVertices(const Batch& batch);

} // namespace edgeshade
