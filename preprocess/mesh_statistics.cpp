#include "preprocess/mesh_statistics.hpp"

#include <numeric>
#include <vector>

namespace edgeshade {
namespace {

/// Disjoint sets of triangles.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }
    void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Whether the triangle runs through the edge from a to b (1) or from b to a (-1).
int directionIn(const Triangle& triangle, const Edge& edge) {
    for (std::size_t c = 0; c < 3; ++c)
        if (triangle[c] == edge.a && triangle[(c + 1) % 3] == edge.b) return 1;
    return -1;
}

/// Whether the triangles on the edge run through it as often in one direction as in the other.
bool isClosedHere(const WeldedMesh& mesh, const EdgeList& edges, const Edge& edge) {
    int sum = 0;
    for (const Opposite& opposite : edges.oppositesOf(edge))
        sum += directionIn(mesh.triangles[opposite.triangle], edge);
    return sum == 0;
}

} // namespace

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
    MeshStatistics statistics;
    statistics.triangles = mesh.triangles.size();
    statistics.degenerateTriangles = mesh.degenerate;
    statistics.edges = edges.edges.size();

    DisjointSets components(mesh.triangles.size());
    for (const Edge& edge : edges.edges) {
        ++statistics.edgesByOppositeCount[edge.oppositeCount];
        const auto opposites = edges.oppositesOf(edge);
        for (std::size_t i = 1; i < opposites.size(); ++i)
            components.unite(opposites[0].triangle, opposites[i].triangle);
    }
    std::vector<bool> open(mesh.triangles.size(), false);
    for (const Edge& edge : edges.edges)
        if (!isClosedHere(mesh, edges, edge))
            open[components.find(edges.opposites[edge.firstOpposite].triangle)] = true;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t root = components.find(t);
        if (root == t) ++statistics.components;
        if (!open[root]) ++statistics.closedOrientedTriangles;
    }
    return statistics;
}

} // namespace edgeshade
