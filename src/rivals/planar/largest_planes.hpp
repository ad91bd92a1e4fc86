#pragma once

#include "preprocess/scene/scene.hpp"

#include <vector>

namespace edgeshade {

/// A triangle of a batch that lies in a plane.
struct PlaneTriangle {
    std::size_t batch = 0;
    std::uint32_t firstIndex = 0; ///< first of its three indices in Geometry::indices
};

/// A plane with the surfaces that lie in it, wherever they are.
struct SurfacePlane {
    glm::dvec4 plane{0.0};  ///< in the world, with a normal of unit length in either direction
    double tolerance = 0.0; ///< scene units: greatest distance of its triangles' vertices
    double area = 0.0;      ///< area of its triangles, in square scene units
    double share = 0.0;     ///< share of the area of all surfaces
    std::vector<PlaneTriangle> triangles; ///< in the order of batches and indices
};

/// Finds the planes with the largest area of surfaces, the largest first, at most `count`. Surfaces
/// are opaque or MASK triangles that no animation moves. Each is in at most one plane; its facing
/// does not matter. A triangle is in a plane if all its vertices are nearer to it than 1e-5 of the
/// diagonal of all surfaces and its normal is within 1.4 degrees of the plane's. Triangles without
/// area are in no plane. Takes time linear in the triangles, times `count`.
std::vector<SurfacePlane> largestPlanes(const Scene& scene, std::size_t count);

} // namespace edgeshade
