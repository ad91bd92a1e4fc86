#include "preprocess/mesh/edges.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// One side of a triangle.
struct HalfEdge {
    std::uint32_t a, b; ///< a < b
    std::uint32_t vertex;
    std::uint32_t triangleAndWay; ///< 2 * triangle + 1 if it runs from a to b

    std::uint32_t triangle() const { return triangleAndWay >> 1; }
    std::uint8_t forward() const { return triangleAndWay & 1u; }
};

bool before(const HalfEdge& p, const HalfEdge& q) {
    if (p.b != q.b) return p.b < q.b;
    if (p.vertex != q.vertex) return p.vertex < q.vertex;
    return p.triangleAndWay < q.triangleAndWay;
}

/// Vertices are divided into at most this many blocks, so that a block's sides fit a cache.
constexpr std::uint32_t mostBlocks = 2048;
constexpr unsigned leastShift = 6;
constexpr std::size_t trianglesOfThread = std::size_t{1} << 14;
/// Sides under a vertex up to which insertion sort is faster.
constexpr std::size_t fewSides = 24;

template <class Use>
void forEachSide(const WeldedMesh& mesh, const ItemRange& triangles, Use use) {
    for (std::size_t t = triangles.first; t < triangles.end; ++t) {
        const Triangle& triangle = mesh.triangles[t];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t u = triangle[c], v = triangle[c == 2 ? 0 : c + 1];
            use(HalfEdge{std::min(u, v), std::max(u, v), triangle[c == 0 ? 2 : c - 1],
                         2 * static_cast<std::uint32_t>(t) + (u < v ? 1u : 0u)});
        }
    }
}

/// All sides, sorted by (a, b, vertex, triangle): divided into blocks by `a`, then each block
/// sorted within the cache.
class SortedSides {
  public:
    SortedSides(const WeldedMesh& mesh, Threads threads)
        : threads_(mesh.triangles.size() < 2 * trianglesOfThread ? Threads{1} : threads),
          vertices_(mesh.positions.size()) {
        while ((vertices_ >> shift_) >= mostBlocks)
            ++shift_;
        divide(mesh);
        edges_.resize(firstOf_.size() - 1);
        inParallel(edges_.size(), threads_, [&](std::size_t block) { sortBlock(block); });
        edgeCount_ = toFirsts(edges_);
    }

    std::size_t edgeCount() const { return edgeCount_; }

    void write(EdgeList& list) const {
        inParallel(edges_.size(), threads_, [&](std::size_t block) { writeBlock(block, list); });
    }

  private:
    void divide(const WeldedMesh& mesh) {
        const std::size_t blocks = (vertices_ >> shift_) + 1;
        const auto parts = partsOf(mesh.triangles.size(), trianglesOfThread, threads_);
        std::vector<std::vector<std::size_t>> places(parts.size());
        forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
            places[part].assign(blocks, 0);
            forEachSide(mesh, range,
                        [&](const HalfEdge& side) { ++places[part][side.a >> shift_]; });
        });
        firstOf_ = toPlaces(places);
        sides_.resize(firstOf_.back());
        forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
            forEachSide(mesh, range, [&](const HalfEdge& side) {
                sides_[places[part][side.a >> shift_]++] = side;
            });
        });
    }

    /// Groups a block's sides by vertex, in their order, then sorts each small group.
    void sortBlock(std::size_t block) {
        const std::span<HalfEdge> sides(&sides_[0] + firstOf_[block],
                                        firstOf_[block + 1] - firstOf_[block]);
        if (sides.empty()) return;
        const std::uint32_t firstVertex = static_cast<std::uint32_t>(block) << shift_;
        std::vector<std::uint32_t> places((std::size_t{1} << shift_) + 1, 0);
        for (const HalfEdge& side : sides)
            ++places[side.a - firstVertex + 1];
        for (std::size_t v = 1; v < places.size(); ++v)
            places[v] += places[v - 1];
        const std::vector<HalfEdge> unsorted(sides.begin(), sides.end());
        for (const HalfEdge& side : unsorted)
            sides[places[side.a - firstVertex]++] = side;
        std::size_t first = 0;
        // each place is now the end of its group
        for (std::size_t v = 0; v + 1 < places.size(); ++v) {
            sortUnderVertex(sides.subspan(first, places[v] - first));
            first = places[v];
        }
        std::size_t edges = 1;
        for (std::size_t i = 1; i < sides.size(); ++i)
            edges += startsEdge(sides, i) ? 1 : 0;
        edges_[block] = edges;
    }

    static void sortUnderVertex(std::span<HalfEdge> sides) {
        if (sides.size() > fewSides) {
            std::sort(sides.begin(), sides.end(), before);
            return;
        }
        for (std::size_t i = 1; i < sides.size(); ++i) {
            const HalfEdge side = sides[i];
            std::size_t at = i;
            for (; at > 0 && before(side, sides[at - 1]); --at)
                sides[at] = sides[at - 1];
            sides[at] = side;
        }
    }

    static bool startsEdge(std::span<const HalfEdge> sides, std::size_t i) {
        return i == 0 || sides[i].a != sides[i - 1].a || sides[i].b != sides[i - 1].b;
    }

    void writeBlock(std::size_t block, EdgeList& list) const {
        const std::size_t first = firstOf_[block];
        const std::span<const HalfEdge> sides(sides_.data() + first, firstOf_[block + 1] - first);
        std::size_t edge = edges_[block];
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const HalfEdge& side = sides[i];
            if (startsEdge(sides, i))
                list.edges[edge++] = {side.a, side.b, static_cast<std::uint32_t>(first + i), 0};
            ++list.edges[edge - 1].oppositeCount;
            list.opposites[first + i] = {side.vertex, side.triangle()};
            list.forward[first + i] = side.forward();
        }
    }

    const Threads threads_;
    const std::size_t vertices_;
    unsigned shift_ = leastShift;
    std::vector<std::size_t> firstOf_; ///< by block, with the end appended
    std::vector<HalfEdge> sides_;
    std::vector<std::size_t> edges_; ///< edges of each block; at the end, edges before it
    std::size_t edgeCount_ = 0;
};

} // namespace

std::uint32_t EdgeList::largestOppositeCount() const {
    std::uint32_t largest = 0;
    for (const Edge& edge : edges)
        largest = std::max(largest, edge.oppositeCount);
    return largest;
}

EdgeList buildEdges(const WeldedMesh& mesh, Threads threads) {
    EdgeList list;
    if (mesh.triangles.empty()) return list;
    const SortedSides sides(mesh, threads);
    list.edges.resize(sides.edgeCount());
    list.opposites.resize(mesh.triangles.size() * 3);
    list.forward.resize(mesh.triangles.size() * 3);
    sides.write(list);
    return list;
}

} // namespace edgeshade
