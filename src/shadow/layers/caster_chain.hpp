#pragma once

#include "src/shadow/layers/caster_facings.hpp"
#include "src/shadow/layers/edge_vertices.hpp"

#include <limits>
#include <vector>

namespace edgeshade {

/// A record whose edge is in the chain of casters (docs/method.md, C48).
struct ChainEdge {
    std::uint32_t record;
    int weight; ///< not 0: the sum of its triangles' facings, each negated if it runs from b to a
};

/// The casters that a search is about, in a batch's space.
struct CasterReach {
    double range = std::numeric_limits<double>::infinity(); ///< as of rangeInObject()
    std::vector<glm::dvec4> planes{}; ///< casters outside one of them don't matter

    /// Whether casters in the box may matter. `light`: the reach's.
    bool mayHold(const Box& box, const LightInBatch& light) const;
};

/// The chain's edges and the uncertain caps, of a batch's clusters within reach.
struct SeenCasters {
    std::vector<ChainEdge> pairs, singles;
    std::vector<std::uint32_t> uncertain; ///< casting caps with facing 0
};

/// The records of one kind in runs of neighbours, and the caps that their planes come from.
struct RecordRuns {
    struct Run {
        RecordRange records;
        RecordRange capRuns; ///< in RecordRuns::capRuns, each once
    };
    std::vector<Run> runs;              ///< each within a cluster
    std::vector<std::uint32_t> capRuns; ///< indices of FollowedFacings' runs
    std::vector<RecordRange> ofCluster; ///< in `runs`
};

/// The edges of record runs in the chain of a light on its way.
struct FollowedEdges {
    std::vector<ChainEdge> edges;       ///< a place per record; a run's edges are in its first ones
    std::vector<std::uint8_t> count;    ///< by run: number of its edges
    std::vector<std::uint32_t> foundAt; ///< by run: FollowedFacings::look that found them
};

/// Keeps what CasterChain finds for a light on its way through a batch's space.
struct FollowedChain {
    FollowedCasters casters;
    FollowedEdges pairs, singles;

    bool isNew() const { return casters.facings.look == 0; }
    /// Facings, one per cap (CasterFacings).
    const std::vector<std::int8_t>& facings() const { return casters.facings.facings; }
};

/// The boundary of a batch's triangles, each signed by the side from which a light sees it.
class CasterChain {
  public:
    /// Linear in the records. `shadow` must outlive this.
    explicit CasterChain(const PlanePairShadow& shadow);

    /// Fills in `seen` for the next place of a light on its way, and reuses its memory. Looks
    /// only at runs whose facings changed. `followed`: new, or of this chain's last look.
    void look(const LightInBatch& light, const CasterReach& reach, FollowedChain& followed,
              SeenCasters& seen) const;

    /// Fills `caps` with all within reach that a ray from a point light may meet, and neighbours of
    /// these. `direction`: in the batch's space.
    void findCapsAlong(const LightInBatch& light, const glm::dvec3& direction,
                       const CasterReach& reach, std::vector<std::uint32_t>& caps) const;

    const PlanePairShadow& shadow() const { return *shadow_; }
    const EdgeVertices& vertices() const { return vertices_; }
    /// Around all casters.
    const Box& bounds() const { return bounds_; }
    /// The largest magnitude of a coordinate.
    double size() const { return facings_.size(); }

  private:
    const PlanePairShadow* shadow_;
    CasterFacings facings_;
    RecordRuns pairs_, singles_;
    EdgeVertices vertices_;
    Box bounds_;
};

} // namespace edgeshade
