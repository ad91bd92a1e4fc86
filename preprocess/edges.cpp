#include "preprocess/edges.hpp"

#include <algorithm>
#include <tuple>

namespace edgeshade {
namespace {

/// One side of one triangle, before sides are grouped into edges.
struct HalfEdge {
    std::uint64_t key; ///< a in the upper half, b in the lower
    Opposite opposite;

    bool operator<(const HalfEdge& other) const {
        return std::tie(key, opposite.vertex, opposite.triangle) <
               std::tie(other.key, other.opposite.vertex, other.opposite.triangle);
    }
};

std::vector<HalfEdge> sortedHalfEdges(const WeldedMesh& mesh) {
    std::vector<HalfEdge> halves;
    halves.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t u = mesh.triangles[t][c];
            const std::uint32_t v = mesh.triangles[t][(c + 1) % 3];
            const std::uint32_t opposite = mesh.triangles[t][(c + 2) % 3];
            const std::uint64_t key = std::uint64_t{std::min(u, v)} << 32 | std::max(u, v);
            halves.push_back({key, {opposite, t}});
        }
    std::sort(halves.begin(), halves.end());
    return halves;
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
    for (const HalfEdge& half : sortedHalfEdges(mesh)) {
        const auto a = static_cast<std::uint32_t>(half.key >> 32);
        const auto b = static_cast<std::uint32_t>(half.key & 0xFFFFFFFFu);
        if (list.edges.empty() || list.edges.back().a != a || list.edges.back().b != b)
            list.edges.push_back({a, b, static_cast<std::uint32_t>(list.opposites.size()), 0});
        ++list.edges.back().oppositeCount;
        list.opposites.push_back(half.opposite);
    }
    return list;
}

} // namespace edgeshade
