#include "preprocess/volumes/cut_border.hpp"

#include "preprocess/base/prefetch.hpp"
#include "preprocess/mesh/edge_numbers.hpp"
#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <bit>
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

/// Prefetches the edges of caps a few after met[i], and their caps, in three steps.
void prefetchEdges(const UncutRecords& uncut, const std::vector<std::uint32_t>& met,
                   std::size_t i) {
    constexpr std::size_t step = 6;
    if (i + 3 * step < met.size()) prefetch(uncut.edgesOf[met[i + 3 * step]]);
    if (i + 2 * step < met.size())
        for (const std::uint32_t edge : uncut.edgesOf[met[i + 2 * step]])
            prefetch(uncut.capsOfEdge[edge]);
    if (i + step < met.size())
        for (const std::uint32_t edge : uncut.edgesOf[met[i + step]])
            prefetch(uncut.edgeCaps[uncut.capsOfEdge[edge].first]);
}

Surroundings surroundingsOf(const UncutRecords& uncut, const std::vector<std::uint32_t>& met,
                            const std::vector<std::uint32_t>& capOf,
                            std::vector<std::uint32_t>& known) {
    // For each cap one of these, or the neighbour's number.
    constexpr std::uint32_t unknown = UncutRecords::none, cut = UncutRecords::none - 1;
    known.resize(std::max(known.size(), capOf.size()), unknown);
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
    for (std::size_t i = 0; i < met.size(); ++i) {
        prefetchEdges(uncut, met, i);
        const std::uint32_t cap = met[i];
        for (const std::uint32_t edge : uncut.edgesOf[cap]) {
            const auto caps = uncut.capsOf(edge);
            const auto first = std::find_if(caps.begin(), caps.end(),
                                            [&](std::uint32_t of) { return known[of] == cut; });
            if (*first == cap) add(edge); // once
        }
    }
    for (const std::uint32_t cap : met)
        known[cap] = unknown;
    for (const Neighbour& of : found.neighbours)
        known[of.cap] = unknown;
    return found;
}

/// Numbers the positions of vertices: equal ones get the same number.
class PositionNumbers {
  public:
    /// `ofVertex`: as in BorderNumbers; `expected`: number of positions, about.
    PositionNumbers(const std::vector<glm::vec3>& positions, std::vector<std::uint32_t>& ofVertex,
                    std::size_t expected)
        : positions_(positions), ofVertex_(ofVertex),
          table_(std::bit_ceil(2 * expected + 64), none) {
        ofVertex_.resize(std::max(ofVertex_.size(), positions_.size()), none);
    }
    ~PositionNumbers() {
        for (const std::uint32_t vertex : vertices_)
            ofVertex_[vertex] = none;
    }
    PositionNumbers(const PositionNumbers&) = delete;
    PositionNumbers& operator=(const PositionNumbers&) = delete;

    std::uint32_t of(std::uint32_t vertex) {
        std::uint32_t& number = ofVertex_[vertex];
        if (number != none) return number;
        vertices_.push_back(vertex);
        if (2 * (distinct.size() + 1) > table_.size()) grow();
        std::uint32_t& place = placeOf(positions_[vertex]);
        if (place == none) {
            place = static_cast<std::uint32_t>(distinct.size());
            distinct.push_back(positions_[vertex]);
        }
        return number = place;
    }

    std::vector<glm::vec3> distinct; ///< by number

  private:
    static constexpr std::uint32_t none = UncutRecords::none;

    static std::size_t hashOf(const glm::vec3& at) {
        std::uint64_t hash = 0; // no coordinate is -0
        for (glm::length_t axis = 0; axis < 3; ++axis)
            hash = (hash ^ glm::floatBitsToUint(at[axis])) * 0x9E3779B97F4A7C15u;
        return static_cast<std::size_t>(hash >> 32);
    }

    /// The position's place in the table, or the free one where it belongs.
    std::uint32_t& placeOf(const glm::vec3& at) {
        std::size_t i = hashOf(at) & (table_.size() - 1); // the size is a power of two
        while (table_[i] != none && distinct[table_[i]] != at)
            i = (i + 1) & (table_.size() - 1);
        return table_[i];
    }

    void grow() {
        table_.assign(4 * table_.size(), none);
        for (std::uint32_t number = 0; number < distinct.size(); ++number)
            placeOf(distinct[number]) = number;
    }

    const std::vector<glm::vec3>& positions_;
    std::vector<std::uint32_t>& ofVertex_;
    std::vector<std::uint32_t> vertices_; ///< that have a number
    std::vector<std::uint32_t> table_;    ///< numbers, by hash
};

/// Collects sides of triangles, edge by edge.
class SideCollector {
  public:
    /// `triangles`: number of those that will be added.
    explicit SideCollector(std::size_t triangles) : numbers_(2 * triangles) {
        sides_.reserve(3 * triangles);
        list_.edges.reserve(2 * triangles);
    }

    /// Adds sides of the next triangle; `which`: as in Neighbour.
    void add(const Triangle& triangle, std::uint32_t which,
             const std::vector<glm::vec3>& positions) {
        for (std::size_t c = 0; c < 3; ++c) {
            if ((which >> c & 1u) == 0) continue;
            const std::uint32_t u = triangle[c], v = triangle[c == 2 ? 0 : c + 1];
            std::uint32_t& edge = numbers_.at(u, v);
            if (edge == EdgeNumbers::none) {
                edge = static_cast<std::uint32_t>(list_.edges.size());
                const bool swaps = orderedBefore(positions[v], positions[u]);
                list_.edges.push_back(swaps ? Edge{v, u, 0, 0} : Edge{u, v, 0, 0});
            }
            ++list_.edges[edge].oppositeCount;
            sides_.push_back({edge,
                              {triangle[c == 0 ? 2 : c - 1], triangles_},
                              std::uint8_t{list_.edges[edge].a == u}});
        }
        ++triangles_;
    }

    EdgeList edges() && {
        std::uint32_t sum = 0;
        for (Edge& edge : list_.edges)
            edge.firstOpposite = (sum += edge.oppositeCount); // their end; filled from the back
        list_.opposites.resize(sum);
        list_.forward.resize(sum);
        for (auto side = sides_.rbegin(); side != sides_.rend(); ++side) {
            const std::uint32_t to = --list_.edges[side->edge].firstOpposite;
            list_.opposites[to] = side->opposite;
            list_.forward[to] = side->forward;
        }
        return std::move(list_);
    }

  private:
    struct Side {
        std::uint32_t edge;
        Opposite opposite;
        std::uint8_t forward;
    };

    EdgeNumbers numbers_;
    EdgeList list_;
    std::vector<Side> sides_;
    std::uint32_t triangles_ = 0;
};

bool areBalanced(const EdgeList& edges) {
    return std::all_of(edges.edges.begin(), edges.edges.end(), [&](const Edge& edge) {
        const auto forward = edges.forwardOf(edge);
        return 2 * std::accumulate(forward.begin(), forward.end(), 0u) == edge.oppositeCount;
    });
}

} // namespace

CutBorder cutBorder(const UncutRecords& uncut, const Geometry& cut, const CutCaps& caps,
                    const CutCaps::Kind& kind, BorderNumbers& numbers) {
    CutBorder border;
    if (kind.pieces.empty() && kind.met.empty()) return border;
    Surroundings around = surroundingsOf(uncut, kind.met, caps.capOf, numbers.ofCap);
    const std::vector<Neighbour>& neighbours = around.neighbours;
    border.replaced = std::move(around.edges);
    const std::size_t triangles = kind.pieces.size() + neighbours.size();
    PositionNumbers positions(cut.positions, numbers.ofVertex, triangles);
    SideCollector sides(triangles);
    const auto add = [&](const Triangle& vertices, std::uint32_t which) {
        sides.add({positions.of(vertices[0]), positions.of(vertices[1]), positions.of(vertices[2])},
                  which, positions.distinct);
    };
    for (const CutCaps::Piece& piece : kind.pieces)
        add(piece.vertices, 7);
    for (const Neighbour& of : neighbours) // the cut geometry begins with the uncut one's vertices
        add(uncut.vertices[of.cap], of.sides);
    border.edges = std::move(sides).edges();
    border.balanced = areBalanced(border.edges);
    border.planes.reserve(triangles);
    border.capOf.reserve(triangles);
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
    border.positions = std::move(positions.distinct);
    return border;
}

} // namespace edgeshade
