#include "src/shadow/culling/kept_records.hpp"

#include "preprocess/mesh/components.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade {
namespace {

/// Writes the records of one edge after the other.
class EdgeRecords {
  public:
    EdgeRecords(const CasterEdges& casters, std::span<const std::uint8_t> gone,
                PlanePairShadow& kept)
        : casters_(casters), gone_(gone), kept_(kept) {}

    void add(const Edge& edge, bool closed) {
        forward_.clear();
        backward_.clear();
        std::uint32_t nothing = 0; // a cap that is gone
        for (const Opposite& opposite : casters_.edges.oppositesOf(edge)) {
            const std::uint32_t cap = casters_.mesh.source[opposite.triangle];
            if (gone_[cap] != 0)
                nothing = cap;
            else
                (directionIn(casters_.mesh.triangles[opposite.triangle], edge) > 0 ? forward_
                                                                                   : backward_)
                    .push_back(cap);
        }
        cancelFlat();
        a_ = casters_.mesh.positions[edge.a];
        b_ = casters_.mesh.positions[edge.b];
        while (!forward_.empty() && !backward_.empty())
            addPair({2 * taken(forward_)}, {2 * taken(backward_)});
        if (closed) { // triangles count by one facing alone: a plane mustn't be negated
            while (!forward_.empty())
                addPair({2 * taken(forward_)}, {2 * nothing});
            while (!backward_.empty())
                addPair({2 * nothing}, {2 * taken(backward_)});
            return;
        }
        for (auto* left : {&forward_, &backward_}) {
            const std::uint32_t turned = left == &backward_ ? 1 : 0;
            while (left->size() > 1)
                addPair({2 * taken(*left) + turned}, {2 * taken(*left) + 1 - turned});
            if (!left->empty())
                kept_.singles.push_back({a_, b_, planeOf({2 * taken(*left) + turned})});
        }
    }

  private:
    using Caps = std::vector<std::uint32_t>;

    static std::uint32_t taken(Caps& caps) {
        const std::uint32_t last = caps.back();
        caps.pop_back();
        return last;
    }

    glm::vec4 planeOf(PlaneOf of) const {
        const glm::vec4& plane = kept_.caps[of.cap()].plane;
        return of.negated() ? -plane : plane;
    }

    /// Takes out pairs whose planes are equal bit for bit (docs/method.md, C4).
    void cancelFlat() {
        for (std::size_t i = 0; i < forward_.size();) {
            const auto same =
                std::find_if(backward_.begin(), backward_.end(), [&](std::uint32_t cap) {
                    return kept_.caps[cap].plane == kept_.caps[forward_[i]].plane;
                });
            if (same == backward_.end()) {
                ++i;
                continue;
            }
            backward_.erase(same);
            forward_.erase(forward_.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

    void addPair(PlaneOf first, PlaneOf second) {
        kept_.pairs.push_back({a_, b_, planeOf(first), planeOf(second)});
        kept_.pairPlanes.push_back({first, second});
    }

    const CasterEdges& casters_;
    std::span<const std::uint8_t> gone_;
    PlanePairShadow& kept_;
    glm::vec3 a_{0.0f}, b_{0.0f};
    Caps forward_, backward_; ///< of the edge at hand, what is kept
};

/// The edges of each cluster.
std::vector<std::vector<std::uint32_t>> edgesByCluster(const PlanePairShadow& shadow,
                                                       const CasterEdges& casters) {
    std::vector<std::uint32_t> clusterOf(shadow.caps.size());
    for (std::uint32_t c = 0; c < shadow.clusters.size(); ++c)
        std::fill_n(clusterOf.begin() + shadow.clusters[c].caps.first,
                    shadow.clusters[c].caps.count, c);
    std::vector<std::vector<std::uint32_t>> edges(shadow.clusters.size());
    for (std::uint32_t e = 0; e < casters.edges.edges.size(); ++e) {
        const Opposite& any = casters.edges.opposites[casters.edges.edges[e].firstOpposite];
        edges[clusterOf[casters.mesh.source[any.triangle]]].push_back(e);
    }
    return edges;
}

RecordRange rangeFrom(std::size_t first, std::size_t end) {
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first)};
}

} // namespace

PlanePairShadow withoutCasters(const PlanePairShadow& shadow, const CasterEdges& casters,
                               std::span<const std::uint8_t> gone) {
    PlanePairShadow kept = shadow;
    kept.pairs.clear();
    kept.pairPlanes.clear();
    kept.singles.clear();
    for (std::size_t i = 0; i < kept.caps.size(); ++i)
        if (gone[i] != 0) kept.caps[i].plane = glm::vec4(0.0f);
    EdgeRecords records(casters, gone, kept);
    const auto edges = edgesByCluster(shadow, casters);
    for (std::size_t c = 0; c < kept.clusters.size(); ++c) {
        ShadowCluster& cluster = kept.clusters[c];
        const std::size_t pairs = kept.pairs.size(), singles = kept.singles.size();
        for (const std::uint32_t edge : edges[c])
            records.add(casters.edges.edges[edge], cluster.closed);
        cluster.pairs = rangeFrom(pairs, kept.pairs.size());
        cluster.singles = rangeFrom(singles, kept.singles.size());
    }
    return kept;
}

} // namespace edgeshade
