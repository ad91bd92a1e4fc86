#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The plane of every triangle: dot(plane, (p, 1)) > 0 on the side from which it is seen
/// counter-clockwise; the normal has unit length. Computed in double and rounded once, so that
/// everything that asks for a triangle's side asks the same four floats (docs/method.md, C1).
///
/// Triangles of a flat patch, oriented alike, coplanar by an exact predicate and connected through
/// edges, share the plane of the largest of them bit for bit. With a `flatTolerance` (degrees, 0 to
/// below 45) the patches are joined to nearly flat ones by growPatches(). (0, 0, 0, 0) for a
/// triangle whose normal can't be told: it has no side, and casts nothing.
std::vector<glm::vec4> trianglePlanes(const WeldedMesh& mesh, const EdgeList& edges,
                                      double flatTolerance = 0.0, Threads threads = {});

/// The plane of one triangle, without patches.
glm::vec4 trianglePlane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

} // namespace edgeshade
