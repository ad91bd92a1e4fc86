#pragma once

#include "src/rays/ray_tree.hpp"
#include "src/rays/surface_triangle.hpp"

#include <vector>

namespace edgeshade::rays {

/// A scene's triangles, and the tree that finds them.
struct SurfaceSet {
    /// `all`: relative to one place, from surfaceTriangles().
    explicit SurfaceSet(std::vector<SurfaceTriangle> all);
    /// `surfaces`: those that points lie on. `all`: their corners, then those of triangles that
    /// only cast and have no holes, which take less memory so. Relative to one place.
    SurfaceSet(std::vector<SurfaceTriangle> surfaces, std::vector<Corners> all);

    std::vector<SurfaceTriangle> triangles;
    std::vector<Corners> corners;    ///< by triangle, and of those that only cast
    std::vector<std::uint8_t> casts; ///< by corners; close together, as every test asks
    RayTree tree;                    ///< of all that have corners
};

} // namespace edgeshade::rays
