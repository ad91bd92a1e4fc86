#include "preprocess/mesh/components.hpp"

#include "preprocess/base/prefetch.hpp"

#include <atomic>

namespace edgeshade {
namespace {

/// Disjoint sets of the numbers 0 .. count - 1 that several threads may join at once. The final
/// root of each set is its lowest number, whatever the order of joins.
class SharedSets {
  public:
    SharedSets(std::size_t count, Threads threads) : parent_(count) {
        forEachItem(count, itemsOfThread, threads, [&](std::size_t i) {
            parent_[i].store(static_cast<std::uint32_t>(i), std::memory_order_relaxed);
        });
    }

    std::uint32_t find(std::uint32_t item) {
        std::uint32_t parent = parentOf(item);
        while (parent != item) {
            // Other threads may shorten the path too; every result leads to the same root.
            const std::uint32_t next = parentOf(parent);
            if (next != parent) parent_[item].store(next, std::memory_order_relaxed);
            item = parent;
            parent = next;
        }
        return item;
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        for (;;) {
            a = find(a);
            b = find(b);
            if (a == b) return;
            if (a < b) std::swap(a, b);
            std::uint32_t root = a; // unless another thread has just attached it elsewhere
            if (parent_[a].compare_exchange_strong(root, b, std::memory_order_relaxed)) return;
        }
    }

    void prefetchItem(std::uint32_t item) const { prefetch(parent_[item]); }

  private:
    std::uint32_t parentOf(std::uint32_t item) const {
        return parent_[item].load(std::memory_order_relaxed);
    }

    std::vector<std::atomic<std::uint32_t>> parent_;
};

bool isClosedHere(const EdgeList& edges, const Edge& edge) {
    std::uint32_t forward = 0;
    for (const std::uint8_t one : edges.forwardOf(edge))
        forward += one;
    return 2 * forward == edge.oppositeCount;
}

/// The number of the component at its first triangle, 0 at all others. Sets `count` to the number
/// of components.
std::vector<std::uint32_t> numbersOf(SharedSets& sets, std::size_t triangles, Threads threads,
                                     std::size_t& count) {
    std::vector<std::uint32_t> numbers(triangles);
    const auto parts = partsOf(triangles, itemsOfThread, threads);
    std::vector<std::uint32_t> firsts(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::uint32_t own = 0;
        for (std::size_t t = range.first; t < range.end; ++t)
            own += sets.find(static_cast<std::uint32_t>(t)) == t ? 1 : 0;
        firsts[part] = own;
    });
    count = toFirsts(firsts);
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        std::uint32_t next = firsts[part];
        for (std::size_t t = range.first; t < range.end; ++t)
            if (sets.find(static_cast<std::uint32_t>(t)) == t) numbers[t] = next++;
    });
    return numbers;
}

} // namespace

int directionIn(const Triangle& triangle, const Edge& edge) {
    for (std::size_t c = 0; c < 3; ++c)
        if (triangle[c] == edge.a && triangle[(c + 1) % 3] == edge.b) return 1;
    return -1;
}

Components findComponents(const WeldedMesh& mesh, const EdgeList& edges, Threads threads) {
    const std::size_t triangles = mesh.triangles.size();
    SharedSets sets(triangles, threads);
    forEachItem(edges.edges.size(), itemsOfThread, threads, [&](std::size_t e) {
        constexpr std::size_t ahead = 8;
        if (e + ahead < edges.edges.size()) {
            const Edge& later = edges.edges[e + ahead];
            sets.prefetchItem(edges.opposites[later.firstOpposite].triangle);
            sets.prefetchItem(
                edges.opposites[later.firstOpposite + later.oppositeCount - 1].triangle);
        }
        const auto opposites = edges.oppositesOf(edges.edges[e]);
        for (std::size_t i = 1; i < opposites.size(); ++i)
            sets.unite(opposites[0].triangle, opposites[i].triangle);
    });

    Components components;
    std::size_t count = 0;
    const std::vector<std::uint32_t> numbers = numbersOf(sets, triangles, threads, count);
    components.ofTriangle.resize(triangles);
    forEachItem(triangles, itemsOfThread, threads, [&](std::size_t t) {
        components.ofTriangle[t] = numbers[sets.find(static_cast<std::uint32_t>(t))];
    });

    components.closed.assign(count, 1);
    const auto parts = partsOf(edges.edges.size(), itemsOfThread, threads);
    std::vector<std::vector<std::uint32_t>> open(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        for (std::size_t e = range.first; e < range.end; ++e) {
            const Edge& edge = edges.edges[e];
            if (isClosedHere(edges, edge)) continue;
            const std::uint32_t triangle = edges.opposites[edge.firstOpposite].triangle;
            const std::uint32_t component = components.ofTriangle[triangle];
            if (open[part].empty() || open[part].back() != component)
                open[part].push_back(component);
        }
    });
    for (const auto& ofPart : open)
        for (const std::uint32_t component : ofPart)
            components.closed[component] = 0;
    return components;
}

MeshTopology topologyOf(const std::vector<glm::vec3>& positions,
                        const std::vector<std::uint32_t>& indices) {
    MeshTopology made;
    made.mesh = weld(positions, indices);
    made.edges = buildEdges(made.mesh);
    made.components = findComponents(made.mesh, made.edges);
    return made;
}

} // namespace edgeshade
