#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Joins flat patches to nearly flat ones. Starting with the largest, each patch absorbs the
/// patches around it whose normals are within `degrees` (> 0, < 45) of its own. They must meet
/// across edges of exactly two triangles that run in opposite directions and bend no more than
/// that. All compare with the original patch, so that normals don't drift and no triangle is turned
/// over.
///
/// `normals`: for every triangle, of a length proportional to its area; zero: the triangle joins
/// nothing. `models`: for every triangle, the triangle whose plane its patch uses; on return, that
/// of the patch it joined. The result depends on the mesh alone.
void growPatches(const WeldedMesh& mesh, const EdgeList& edges, std::span<const glm::dvec3> normals,
                 double degrees, std::vector<std::uint32_t>& models);

} // namespace edgeshade
