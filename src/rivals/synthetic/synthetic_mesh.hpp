#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::bench {

/// Whether the edges of a synthetic mesh are silhouette edges for syntheticLight.
enum class Silhouette { all, none };

/// Edges without triangles: all of a mesh that the silhouette evaluation sees.
struct SyntheticMesh {
    std::vector<glm::vec3> positions; ///< ascending, as in a welded mesh
    EdgeList edges;
};

/// In the meshes' space.
inline constexpr glm::vec4 syntheticLight{0.0f, 0.0f, 0.0f, 1.0f};

/// `edgeCount` edges with `oppositeCount` opposite vertices each. All: every edge's multiplicity is
/// plus or minus `oppositeCount`. None: it is 0, as for every record that an edge is split into.
/// Opposite vertices lie in pairs on both sides of the plane through edge and light, and an odd one
/// lies in that plane.
SyntheticMesh syntheticMesh(std::size_t edgeCount, int oppositeCount, Silhouette silhouette);

} // namespace edgeshade::bench
