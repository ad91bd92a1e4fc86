#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::bench {

/// Whether the edges of a synthetic mesh are silhouette edges for syntheticLight.
enum class Silhouette { all, none };

/// Edges and nothing else: what evaluating the silhouette sees of a mesh.
struct SyntheticMesh {
    std::vector<glm::vec3> positions; ///< in ascending order, as a welded mesh has them
    EdgeList edges;
};

/// In the space of the meshes.
inline constexpr glm::vec4 syntheticLight{0.0f, 0.0f, 0.0f, 1.0f};

/// `edgeCount` edges with `oppositeCount` opposite vertices each. All: every edge's multiplicity is
/// plus or minus `oppositeCount`. None: it is 0, and so is that of each record that an edge is
/// split into: opposite vertices lie in pairs on both sides of the plane through edge and light,
/// an odd one in that plane.
SyntheticMesh syntheticMesh(std::size_t edgeCount, int oppositeCount, Silhouette silhouette);

} // namespace edgeshade::bench
