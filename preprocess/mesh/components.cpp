#include "preprocess/mesh/components.hpp"

#include "preprocess/base/disjoint_sets.hpp"

namespace edgeshade {
namespace {

bool isClosedHere(const WeldedMesh& mesh, const EdgeList& edges, const Edge& edge) {
    int sum = 0;
    for (const Opposite& opposite : edges.oppositesOf(edge))
        sum += directionIn(mesh.triangles[opposite.triangle], edge);
    return sum == 0;
}

} // namespace

int directionIn(const Triangle& triangle, const Edge& edge) {
    for (std::size_t c = 0; c < 3; ++c)
        if (triangle[c] == edge.a && triangle[(c + 1) % 3] == edge.b) return 1;
    return -1;
}

Components findComponents(const WeldedMesh& mesh, const EdgeList& edges) {
    DisjointSets sets(mesh.triangles.size());
    for (const Edge& edge : edges.edges) {
        const auto opposites = edges.oppositesOf(edge);
        for (std::size_t i = 1; i < opposites.size(); ++i)
            sets.unite(opposites[0].triangle, opposites[i].triangle);
    }
    constexpr std::uint32_t none = 0xFFFFFFFFu;
    Components components;
    std::vector<std::uint32_t> numberOf(mesh.triangles.size(), none);
    components.ofTriangle.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        std::uint32_t& number = numberOf[sets.find(t)];
        if (number == none) {
            number = static_cast<std::uint32_t>(components.closed.size());
            components.closed.push_back(1);
        }
        components.ofTriangle.push_back(number);
    }
    for (const Edge& edge : edges.edges)
        if (!isClosedHere(mesh, edges, edge)) {
            const std::uint32_t triangle = edges.opposites[edge.firstOpposite].triangle;
            components.closed[components.ofTriangle[triangle]] = 0;
        }
    return components;
}

} // namespace edgeshade
