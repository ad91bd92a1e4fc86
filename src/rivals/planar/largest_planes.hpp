#pragma once

#include "preprocess/scene/scene.hpp"

#include <vector>

namespace edgeshade {

/// A triangle of a batch that lies in a plane.
struct PlaneTriangle {
    std::size_t batch = 0;
    std::uint32_t firstIndex = 0; ///< of its three in Geometry::indices
};

/// A plane with the surfaces that lie in it, wherever they are.
struct SurfacePlane {
    glm::dvec4 plane{0.0};  ///< in the world, its normal of unit length, of either direction
    double tolerance = 0.0; ///< scene units: no vertex of its triangles is farther from it
    double area = 0.0;      ///< of these, in square scene units
    double share = 0.0;     ///< of the area of all surfaces
    std::vector<PlaneTriangle> triangles; ///< in the order of batches and indices
};

/// The planes with the most area of surfaces in them, the largest first, at most `count`. Surfaces
/// are opaque or MASK, and none that an animation moves. Each is in one plane at the most; which
/// way it faces doesn't matter. A triangle is in a plane where all its vertices are nearer to it
/// than 1e-5 of the diagonal of all surfaces and its normal is within 1.4 degrees of the plane's.
/// Triangles without area are in none. Takes time linear in the triangles, times `count`.
std::vector<SurfacePlane> largestPlanes(const Scene& scene, std::size_t count);

} // namespace edgeshade
