#include "preprocess/volumes/cut_border.hpp"

#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade {
namespace {

/// A cap that stays as it was, and those of its sides that a cut cap had too: bit 0 for the side
/// from a to b, bit 1 from b to c, bit 2 from c to a.
struct Neighbour {
    std::uint32_t cap; ///< before the cut
    std::uint32_t sides;
};

/// The edges of caps that were cut, and their other caps.
struct Surroundings {
    std::vector<std::uint32_t> edges;
    std::vector<Neighbour> neighbours;
};

Surroundings surroundingsOf(const UncutRecords& uncut, const std::vector<std::uint32_t>& met,
                            const std::vector<std::uint32_t>& capOf) {
    constexpr std::uint32_t unknown = UncutRecords::none, cut = UncutRecords::none - 1;
    std::vector<std::uint32_t> known(capOf.size(), unknown); // by cap; or the neighbour's number
    for (const std::uint32_t cap : met)
        known[cap] = cut;
    Surroundings found;
    found.edges.reserve(3 * met.size());
    found.neighbours.reserve(met.size());
    const auto add = [&](std::uint32_t edge) {
        found.edges.push_back(edge);
        for (const std::uint32_t cap : uncut.capsOf(edge)) {
            if (capOf[cap] == UncutRecords::none) continue;
            if (known[cap] == unknown) {
                known[cap] = static_cast<std::uint32_t>(found.neighbours.size());
                found.neighbours.push_back({cap, 0});
            }
            for (std::uint32_t side = 0; side < 3; ++side)
                if (uncut.edgesOf[cap][side] == edge)
                    found.neighbours[known[cap]].sides |= 1u << side;
        }
    };
    for (const std::uint32_t cap : met)
        for (const std::uint32_t edge : uncut.edgesOf[cap]) {
            const auto caps = uncut.capsOf(edge);
            const auto first = std::find_if(caps.begin(), caps.end(),
                                            [&](std::uint32_t of) { return known[of] == cut; });
            if (*first == cap) add(edge); // once
        }
    return found;
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
    some.edges.reserve(all.edges.size());
    some.opposites.reserve(all.opposites.size());
    some.forward.reserve(all.opposites.size());
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
    Surroundings around = surroundingsOf(uncut, kind.met, caps.capOf);
    const std::vector<Neighbour>& neighbours = around.neighbours;
    border.replaced = std::move(around.edges);
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
    border.planes.reserve(pieces + neighbours.size());
    border.capOf.reserve(pieces + neighbours.size());
    const auto position = [&](std::uint32_t vertex) { return cut.positions[vertex]; };
    for (const CutCaps::Piece& piece : kind.pieces) {
        const auto& [a, b, c] = piece.vertices;
        border.planes.push_back(trianglePlane(position(a), position(b), position(c)));
        border.capOf.push_back(piece.cap);
    }
    for (const Neighbour& of : neighbours) {
        border.planes.push_back(uncut.shadow->caps[of.cap].plane);
        border.capOf.push_back(caps.capOf[of.cap]);
    }
    return border;
}

} // namespace edgeshade
