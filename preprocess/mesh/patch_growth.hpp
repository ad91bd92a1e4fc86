#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Joins flat patches to nearly flat ones. From the largest patch on, each takes in the patches
/// around it whose normals are within `degrees` (> 0, < 45) of its own, across edges of exactly two
/// triangles that run opposite ways and bend no more than that. All compare with the patch that it
/// began with, so normals don't drift, and no triangle is turned over.
///
/// `normals`: of every triangle, as long as its area is large; zero: it joins nothing. `models`: of
/// every triangle, the one of its patch whose plane all of it takes; that of the patch joined,
/// afterwards. The result depends on the mesh alone.
void growPatches(const WeldedMesh& mesh, const EdgeList& edges, std::span<const glm::dvec3> normals,
                 double degrees, std::vector<std::uint32_t>& models);

} // namespace edgeshade
