#pragma once

#include "preprocess/volumes/shadow_data.hpp"

#include <cstdlib>
#include <span>

namespace edgeshade::test {

/// Number of edges at which the sides don't fit the caps (docs/method.md, The closed chain): the
/// multiplicities of an edge's records must sum to the signs of its triangles, each with the
/// direction in which the sorted triangle A < B < C runs through the edge (A to B and B to C: +, A
/// to C: -).
///
/// multiplicities: one per record of buildSides(); signs: one per triangle.
inline std::size_t openEdges(const BatchTopology& topology, int maxMultiplicity,
                             std::span<const int> multiplicities, std::span<const int> signs) {
    std::size_t open = 0, record = 0;
    for (const Edge& edge : topology.edges.edges) {
        int fromCaps = 0;
        for (const Opposite& opposite : topology.edges.oppositesOf(edge)) {
            const bool between = opposite.vertex > edge.a && opposite.vertex < edge.b;
            fromCaps += (between ? -1 : 1) * signs[opposite.triangle];
        }
        int fromSides = 0;
        for (std::uint32_t done = 0; done < edge.oppositeCount;
             done += static_cast<std::uint32_t>(maxMultiplicity))
            fromSides += multiplicities[record++];
        open += fromSides != fromCaps;
    }
    return open;
}

} // namespace edgeshade::test
