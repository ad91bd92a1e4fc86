#pragma once

#include "src/hours/surfaces/world_triangles.hpp"

#include <span>

namespace edgeshade::hours {

/// Neighbouring triangles of one node and one material in one plane, and the axes of a grid on it.
struct Patch {
    std::vector<std::uint32_t> triangles; ///< indices, the largest first
    glm::dvec3 origin{0.0};               ///< a point of the plane, in the world
    /// Unit axes: `right` and `up` span the plane, `normal` points to the front. On walls and
    /// slopes `right` is horizontal; on level patches it follows the longest border.
    glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 0.0, -1.0}, normal{0.0, 1.0, 0.0};
};

/// Joins triangles into patches, from the largest triangle on. A neighbour shares an edge, which
/// runs the other way there, and its corners are as near to the first triangle's plane as the
/// rounding of a file's floats explains: this grows with the distance from that triangle, up to
/// `flatness` (scene units, above 0). Triangles without area are in no patch.
///
/// `triangles`: the scene's, from worldTriangles().
std::vector<Patch> patchesOf(const Scene& scene, std::span<const WorldTriangle> triangles,
                             double flatness);

} // namespace edgeshade::hours
