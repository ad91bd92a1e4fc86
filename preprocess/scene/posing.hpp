#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Puts the vertices of a batch that deforms where a shape has them, with their normals and
/// tangents: morph targets first, then joints, in double, rounded once. False where a position does
/// not fit into a float; the batch stays as it was.
bool poseBatch(Batch& batch, const BatchShape& shape);

/// By vertex of a batch that deforms: the first vertex that is where it is in whatever pose.
std::vector<std::uint32_t> alikeVertices(const Batch& batch);

} // namespace edgeshade
