#include "preprocess/volumes/cut_border.hpp"

#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade {
namespace {

/// The edges of caps that were cut, ascending.
std::vector<std::uint32_t> edgesOfCut(const UncutRecords& uncut,
                                      const std::vector<std::uint32_t>& met) {
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t cap : met)
        edges.insert(edges.end(), uncut.edgesOf[cap].begin(), uncut.edgesOf[cap].end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// A cap that stays as it was, and those of its sides that a cut cap had too: bit 0 for the side
/// from a to b, bit 1 from b to c, bit 2 from c to a.
struct Neighbour {
    std::uint32_t cap; ///< before the cut
    std::uint32_t sides;
};

std::vector<Neighbour> neighboursOf(const UncutRecords& uncut,
                                    const std::vector<std::uint32_t>& edges, const CutCaps& caps) {
    std::vector<Neighbour> found;
    for (const std::uint32_t edge : edges)
        for (const std::uint32_t cap : uncut.capsOf(edge)) {
            if (caps.capOf[cap] == UncutRecords::none) continue;
            const auto& own = uncut.edgesOf[cap];
            found.push_back({cap, 1u << static_cast<std::uint32_t>(
                                      std::find(own.begin(), own.end(), edge) - own.begin())});
        }
    std::sort(found.begin(), found.end(),
              [](const Neighbour& s, const Neighbour& t) { return s.cap < t.cap; });
    std::vector<Neighbour> joined;
    for (const Neighbour& one : found)
        if (!joined.empty() && joined.back().cap == one.cap)
            joined.back().sides |= one.sides;
        else
            joined.push_back(one);
    return joined;
}

/// Welds the pieces, then the neighbours. The cut geometry begins with the vertices of the uncut
/// one.
WeldedMesh weldedOf(const UncutRecords& uncut, const std::vector<glm::vec3>& positions,
                    const std::vector<CutCaps::Piece>& pieces,
                    const std::vector<Neighbour>& neighbours) {
    // Few of the vertices are here, most of them in several triangles.
    std::vector<std::uint32_t> numberOf(positions.size(), UncutRecords::none);
    std::vector<glm::vec3> used;
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * (pieces.size() + neighbours.size()));
    const auto add = [&](const Triangle& vertices) {
        for (const std::uint32_t vertex : vertices) {
            if (numberOf[vertex] == UncutRecords::none) {
                numberOf[vertex] = static_cast<std::uint32_t>(used.size());
                used.push_back(positions[vertex]);
            }
            indices.push_back(numberOf[vertex]);
        }
    };
    for (const CutCaps::Piece& piece : pieces)
        add(piece.vertices);
    for (const Neighbour& of : neighbours)
        add(uncut.vertices[of.cap]);
    return weld(used, indices, {1});
}

/// The edges of a mesh, without the sides of triangles that `counts` refuses.
template <class Counts>
EdgeList edgesWhere(const EdgeList& all, const Counts& counts) {
    EdgeList some;
    for (const Edge& edge : all.edges) {
        Edge own = edge;
        own.firstOpposite = static_cast<std::uint32_t>(some.opposites.size());
        for (std::uint32_t i = edge.firstOpposite; i < edge.firstOpposite + edge.oppositeCount; ++i)
            if (counts(all.opposites[i])) {
                some.opposites.push_back(all.opposites[i]);
                some.forward.push_back(all.forward[i]);
            }
        own.oppositeCount = static_cast<std::uint32_t>(some.opposites.size()) - own.firstOpposite;
        if (own.oppositeCount > 0) some.edges.push_back(own);
    }
    return some;
}

bool areBalanced(const EdgeList& edges) {
    return std::all_of(edges.edges.begin(), edges.edges.end(), [&](const Edge& edge) {
        const auto forward = edges.forwardOf(edge);
        return 2 * std::accumulate(forward.begin(), forward.end(), 0u) == edge.oppositeCount;
    });
}

} // namespace

CutBorder cutBorder(const UncutRecords& uncut, const Geometry& cut, const CutCaps& caps,
                    const CutCaps::Kind& kind) {
    CutBorder border;
    if (kind.pieces.empty() && kind.met.empty()) return border;
    border.replaced = edgesOfCut(uncut, kind.met);
    const std::vector<Neighbour> neighbours = neighboursOf(uncut, border.replaced, caps);
    border.mesh = weldedOf(uncut, cut.positions, kind.pieces, neighbours);
    const std::size_t pieces = kind.pieces.size(); // all have an area, so that none is dropped
    border.edges = edgesWhere(buildEdges(border.mesh, {1}), [&](const Opposite& of) {
        if (of.triangle < pieces) return true;
        const Triangle& corners = border.mesh.triangles[of.triangle];
        const auto opposite = std::find(corners.begin(), corners.end(), of.vertex);
        const auto side = static_cast<std::uint32_t>(opposite - corners.begin() + 1) % 3;
        return (neighbours[of.triangle - pieces].sides >> side & 1u) != 0;
    });
    border.balanced = areBalanced(border.edges);
    border.planes = trianglePlanes(border.mesh, border.edges, 0.0, {1});
    for (const CutCaps::Piece& piece : kind.pieces)
        border.capOf.push_back(piece.cap);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        border.capOf.push_back(caps.capOf[neighbours[i].cap]);
        border.planes[pieces + i] = uncut.shadow->caps[neighbours[i].cap].plane;
    }
    return border;
}

} // namespace edgeshade
