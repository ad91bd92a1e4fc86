#pragma once

#include "src/rays/ray_tree.hpp"
#include "src/rays/surface_triangle.hpp"

#include <vector>

namespace edgeshade::rays {

/// A scene's triangles, and the tree that finds them.
struct SurfaceSet {
    /// `all`: relative to one place, from surfaceTriangles().
    explicit SurfaceSet(std::vector<SurfaceTriangle> all);

    std::vector<SurfaceTriangle> triangles;
    std::vector<Corners> corners;    ///< by triangle
    std::vector<std::uint8_t> casts; ///< by triangle; close together, as every test asks
    RayTree tree;                    ///< of all triangles
};

} // namespace edgeshade::rays
