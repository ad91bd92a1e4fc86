#pragma once

#include "src/rays/ray_tree.hpp"
#include "src/rays/surface_triangle.hpp"

#include <functional>
#include <vector>

namespace edgeshade::rays {

/// Whether light passes through an alpha-tested caster at barycentric coordinates (u, v) of its
/// second and third corner.
using IsHole = std::function<bool(const SurfaceTriangle&, double u, double v)>;

/// A scene's triangles, and the tree of those that cast.
struct Casters {
    /// As for LitRays.
    Casters(const Scene& scene, std::vector<SurfaceTriangle> all, IsHole hole);

    /// Whether light passes through where the line from `origin` meets the triangle.
    bool isHoleAt(std::uint32_t triangle, const glm::dvec3& origin,
                  const glm::dvec3& direction) const;

    std::vector<SurfaceTriangle> triangles;
    std::vector<Corners> corners;           ///< by triangle
    std::vector<std::uint8_t> mayHaveHoles; ///< by triangle; empty: none has
    IsHole isHole;                          ///< may be null
    RayTree tree;
};

} // namespace edgeshade::rays
