#pragma once

#include "preprocess/mesh/weld.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// A vertex opposite an edge: the third vertex of a triangle on the edge.
struct Opposite {
    std::uint32_t vertex = 0;
    std::uint32_t triangle = 0;
    bool operator==(const Opposite&) const = default;
};

/// An edge `a < b` and the position of its opposite vertices in EdgeList::opposites.
struct Edge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t firstOpposite = 0;
    std::uint32_t oppositeCount = 0; ///< n >= 1
    bool operator==(const Edge&) const = default;
};

/// All edges of a welded mesh, sorted by (a, b); the opposites of an edge are sorted by (vertex,
/// triangle).
struct EdgeList {
    std::vector<Edge> edges;
    std::vector<Opposite> opposites; ///< three per triangle
    /// For each of `opposites`: 1 if its triangle runs through the edge from a to b, 0 if from b to
    /// a. Filled by buildEdges() alone.
    std::vector<std::uint8_t> forward;

    std::span<const Opposite> oppositesOf(const Edge& edge) const {
        return std::span(opposites).subspan(edge.firstOpposite, edge.oppositeCount);
    }
    std::span<const std::uint8_t> forwardOf(const Edge& edge) const {
        return std::span(forward).subspan(edge.firstOpposite, edge.oppositeCount);
    }
    std::uint32_t largestOppositeCount() const;
};

/// Finds every edge, with any number of opposite vertices (docs/method.md, Terms).
EdgeList buildEdges(const WeldedMesh& mesh, Threads threads = {});

} // namespace edgeshade
