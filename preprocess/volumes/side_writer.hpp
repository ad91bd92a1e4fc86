#pragma once

#include "preprocess/base/prefetch.hpp"
#include "preprocess/volumes/opposite_pairs.hpp"
#include "preprocess/volumes/plane_pair_records.hpp"

namespace edgeshade {

/// Writes the records of some edges from given positions on.
class SideWriter {
  public:
    SideWriter(const std::vector<glm::vec3>& positions, const EdgeList& edges,
               const std::vector<glm::vec4>& planes, const std::vector<std::uint32_t>& capOf)
        : positions_(positions), edges_(edges), planes_(planes), capOf_(capOf) {}

    std::size_t pair = 0, single = 0; ///< where the next records go
    std::size_t flatPairs = 0, flatEdges = 0;

    /// `vertices`: also filled in if the records serve all poses; then no pair is dropped.
    void write(const Edge& edge, PlanePairShadow& shadow, RecordVertices* vertices) {
        const std::size_t before = pair + single;
        if (edge.oppositeCount <= 2) {
            write(edge, onlyPair(edges_, edge), shadow, vertices);
        } else {
            pairUp(edges_, edge, planes_, paired_);
            for (const OppositePair& two : paired_)
                write(edge, two, shadow, vertices);
        }
        flatEdges += pair + single == before;
    }

    /// Prefetches write()'s data of an edge in two steps, the second a few edges after the first.
    void prefetchEdge(const Edge& edge) const {
        prefetch(edges_.opposites[edge.firstOpposite]);
        prefetch(edges_.forward[edge.firstOpposite]);
        prefetch(positions_[edge.a]);
        prefetch(positions_[edge.b]);
    }
    void prefetchTriangles(const Edge& edge) const {
        for (const std::uint32_t last : {0u, edge.oppositeCount - 1}) {
            const std::uint32_t triangle = edges_.opposites[edge.firstOpposite + last].triangle;
            prefetch(planes_[triangle]);
            prefetch(capOf_[triangle]);
        }
    }

  private:
    void write(const Edge& edge, const OppositePair& two, PlanePairShadow& shadow,
               RecordVertices* vertices) {
        const glm::vec3 &a = positions_[edge.a], &b = positions_[edge.b];
        const glm::vec4 plane = two.first.planeIn(planes_);
        if (!two.second) {
            shadow.singles[single] = {a, b, plane};
            if (vertices) vertices->singles[single] = {edge.a, edge.b};
            shadow.singlePlanes[single] = planeOf(two.first);
            ++single;
            return;
        }
        const glm::vec4 other = two.second->planeIn(planes_);
        if (plane == other && !vertices) {
            ++flatPairs;
            return;
        }
        shadow.pairs[pair] = {a, b, plane, other};
        shadow.pairPlanes[pair] = {planeOf(two.first), planeOf(*two.second)};
        if (vertices) vertices->pairs[pair] = {edge.a, edge.b};
        ++pair;
    }

    PlaneOf planeOf(const PairedTriangle& of) const {
        return {2 * capOf_[of.triangle] + (of.negated ? 1u : 0u)};
    }

    const std::vector<glm::vec3>& positions_;
    const EdgeList& edges_;
    const std::vector<glm::vec4>& planes_;
    const std::vector<std::uint32_t>& capOf_; ///< by triangle
    std::vector<OppositePair> paired_;
};

} // namespace edgeshade
