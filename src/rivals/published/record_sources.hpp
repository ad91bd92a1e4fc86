#pragma once

#include "src/scene/record_source.hpp"

namespace edgeshade {

/// Makes opposite-vertex records, as published: caps, and sides with one largest multiplicity for
/// the whole scene.
std::unique_ptr<RecordSource> oppositeVertexSource();

/// Makes records of single triangles, for brute force.
std::unique_ptr<RecordSource> triangleSource();

} // namespace edgeshade
