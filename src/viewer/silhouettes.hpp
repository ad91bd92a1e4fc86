#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade::viewer {

/// Numbers of the scene's edges: all records, and those that cast a side for a light.
struct EdgeCounts {
    std::size_t records = 0;
    std::size_t edges = 0;
    std::size_t silhouettes = 0; ///< records with non-zero multiplicity (docs/method.md, Terms)
};

/// Counts in double precision, for display: the vertex shader alone decides what is drawn.
EdgeCounts countEdges(const LoadedScene& loaded, const Light& light);

} // namespace edgeshade::viewer
