#include "src/shadow/plan/side_sample.hpp"

#include "src/shadow/plan/record_multiplicity.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// An edge that may be a silhouette, of a pair or of a single.
struct CandidateEdge {
    glm::vec3 a, b;
    int multiplicity;
};

/// Those of a cluster, one after the other.
class CandidateEdges {
  public:
    CandidateEdges(const BatchPlan& batch, const ClusterPlan& draw)
        : batch_(batch), counted_(draw.counted),
          singles_(batch.shadow->clusters[draw.clusters.first].singles),
          certain_(batch.silhouettes->certain.ofCluster[draw.clusters.first]),
          uncertain_(batch.silhouettes->uncertain.ofCluster[draw.clusters.first]) {}

    std::uint32_t count() const { return singles_.count + certain_.count + uncertain_.count; }

    CandidateEdge at(std::uint32_t i) const {
        const PlanePairShadow& shadow = *batch_.shadow;
        if (i < singles_.count) return edgeOf(shadow.singles[singles_.first + i]);
        i -= singles_.count;
        if (i < certain_.count)
            return edgeOf(shadow.pairs[batch_.silhouettes->certain.pairs[certain_.first + i]]);
        i -= certain_.count;
        return edgeOf(shadow.pairs[batch_.silhouettes->uncertain.pairs[uncertain_.first + i]]);
    }

  private:
    template <class Record>
    CandidateEdge edgeOf(const Record& record) const {
        return {record.a, record.b, multiplicityOf(record, batch_.light, counted_)};
    }

    const BatchPlan& batch_;
    Counted counted_;
    RecordRange singles_, certain_, uncertain_;
};

} // namespace

std::vector<SampledEdge> sampledEdges(const BatchPlan& batch, const ClusterPlan& draw,
                                      std::uint32_t most) {
    const CandidateEdges edges(batch, draw);
    const std::uint32_t samples = std::min(most, edges.count());
    std::vector<SampledEdge> taken;
    for (std::uint32_t s = 0; s < samples; ++s) {
        const CandidateEdge edge =
            edges.at(static_cast<std::uint32_t>(std::uint64_t{s} * edges.count() / samples));
        if (edge.multiplicity == 0) continue;
        taken.push_back(
            {glm::dvec3(edge.a), glm::dvec3(edge.b), static_cast<double>(edges.count()) / samples});
    }
    return taken;
}

} // namespace edgeshade
