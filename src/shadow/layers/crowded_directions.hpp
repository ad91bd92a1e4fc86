#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/layers/crowded_cells.hpp"
#include "src/shadow/lights/light.hpp"

#include <cstddef>
#include <vector>

namespace edgeshade {

/// Directions from a light in which many casters are behind each other.
struct CrowdedDirections {
    /// No straight line from the light, up to its range, meets more casting triangles than this.
    std::size_t most = 0;
    /// For each small cell of directions that may meet more than `limit` triangles, those
    /// triangles.
    std::vector<TriangleIndices> crowded;
};

/// Counts how many triangles may touch the cells of a grid of directions, and of finer grids where
/// they are more than `limit`. It divides crowded cells down to 1/4096 of a cube's face (of the
/// scene's outline for a directional light), where it stops. Takes 8 ms for 150,000 triangles if
/// few are behind each other, up to 50 ms if many are.
CrowdedDirections crowdedDirections(const Scene& scene, bool castMasked, const Light& light,
                                    std::size_t limit);

} // namespace edgeshade
