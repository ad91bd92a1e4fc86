#include "preprocess/mesh/mesh_statistics.hpp"

namespace edgeshade {

MeshStatistics& MeshStatistics::operator+=(const MeshStatistics& other) {
    triangles += other.triangles;
    degenerateTriangles += other.degenerateTriangles;
    edges += other.edges;
    for (const auto& [n, count] : other.edgesByOppositeCount)
        edgesByOppositeCount[n] += count;
    components += other.components;
    closedOrientedTriangles += other.closedOrientedTriangles;
    return *this;
}

MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges) {
    return meshStatistics(mesh, edges, findComponents(mesh, edges));
}

MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges,
                              const Components& components) {
    MeshStatistics statistics;
    statistics.triangles = mesh.triangles.size();
    statistics.degenerateTriangles = mesh.degenerate;
    statistics.edges = edges.edges.size();

    for (const Edge& edge : edges.edges)
        ++statistics.edgesByOppositeCount[edge.oppositeCount];
    statistics.components = components.count();
    for (const std::uint32_t component : components.ofTriangle)
        statistics.closedOrientedTriangles += components.closed[component];
    return statistics;
}

} // namespace edgeshade
