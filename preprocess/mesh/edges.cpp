#include "preprocess/mesh/edges.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace edgeshade {
namespace {

/// One side of one triangle, under the smaller vertex of its edge.
struct HalfEdge {
    std::uint32_t b; ///< the larger vertex
    Opposite opposite;

    bool operator<(const HalfEdge& other) const {
        return std::tie(b, opposite.vertex, opposite.triangle) <
               std::tie(other.b, other.opposite.vertex, other.opposite.triangle);
    }
};

/// All sides, those under one vertex together and sorted.
struct HalfEdges {
    std::vector<HalfEdge> halves;
    std::vector<std::uint32_t> firstOf; ///< by vertex; one more than there are vertices
};

template <class Use>
void forEachSide(const WeldedMesh& mesh, Use use) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t u = mesh.triangles[t][c];
            const std::uint32_t v = mesh.triangles[t][(c + 1) % 3];
            use(std::min(u, v), HalfEdge{std::max(u, v), {mesh.triangles[t][(c + 2) % 3], t}});
        }
}

/// Counted by their smaller vertex, so that only the few under one are ever compared.
HalfEdges sortedHalfEdges(const WeldedMesh& mesh) {
    HalfEdges result;
    std::vector<std::uint32_t>& firstOf = result.firstOf;
    firstOf.assign(mesh.positions.size() + 1, 0);
    forEachSide(mesh, [&](std::uint32_t a, const HalfEdge&) { ++firstOf[a + 1]; });
    std::partial_sum(firstOf.begin(), firstOf.end(), firstOf.begin());
    result.halves.resize(mesh.triangles.size() * 3);
    std::vector<std::uint32_t> next(firstOf.begin(), firstOf.end() - 1);
    forEachSide(mesh,
                [&](std::uint32_t a, const HalfEdge& half) { result.halves[next[a]++] = half; });
    for (std::size_t a = 0; a + 1 < firstOf.size(); ++a)
        std::sort(result.halves.begin() + firstOf[a], result.halves.begin() + firstOf[a + 1]);
    return result;
}

} // namespace

std::uint32_t EdgeList::largestOppositeCount() const {
    std::uint32_t largest = 0;
    for (const Edge& edge : edges)
        largest = std::max(largest, edge.oppositeCount);
    return largest;
}

EdgeList buildEdges(const WeldedMesh& mesh) {
    EdgeList list;
    list.opposites.reserve(mesh.triangles.size() * 3);
    list.edges.reserve(mesh.triangles.size() * 3 / 2);
    const HalfEdges sides = sortedHalfEdges(mesh);
    for (std::uint32_t a = 0; a < mesh.positions.size(); ++a)
        for (std::uint32_t i = sides.firstOf[a]; i < sides.firstOf[a + 1]; ++i) {
            const HalfEdge& half = sides.halves[i];
            if (i == sides.firstOf[a] || list.edges.back().b != half.b)
                list.edges.push_back(
                    {a, half.b, static_cast<std::uint32_t>(list.opposites.size()), 0});
            ++list.edges.back().oppositeCount;
            list.opposites.push_back(half.opposite);
        }
    return list;
}

} // namespace edgeshade
