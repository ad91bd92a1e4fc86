#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The plane of every triangle: dot(plane, (p, 1)) > 0 on the side from which it is
/// counter-clockwise; the normal has unit length. It is computed in double precision and rounded
/// once, so that everything that needs a triangle's side evaluates the same four floats
/// (docs/method.md, C1).
///
/// Triangles of a flat patch share the plane of the largest of them bit for bit. They have the same
/// orientation, are coplanar by an exact predicate, and are connected through edges. With a
/// `flatTolerance` (degrees, 0 to below 45) growPatches() joins the patches to nearly flat ones.
/// The plane is (0, 0, 0, 0) for a triangle whose normal can't be determined: it has no side, and
/// casts nothing.
std::vector<glm::vec4> trianglePlanes(const WeldedMesh& mesh, const EdgeList& edges,
                                      double flatTolerance = 0.0, Threads threads = {});

/// The plane of one triangle, without patches.
glm::vec4 trianglePlane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

} // namespace edgeshade
