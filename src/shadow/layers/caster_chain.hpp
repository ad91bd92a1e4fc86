#pragma once

#include "src/shadow/layers/caster_facings.hpp"

namespace edgeshade {

/// A record whose edge is in the chain of casters (docs/method.md, C48).
struct ChainEdge {
    std::uint32_t record;
    int weight; ///< not 0: the sum of its triangles' facings, each negated if it runs from b to a
};

/// The chain's edges and the uncertain caps, of a batch's clusters within a light's range.
struct SeenCasters {
    std::vector<ChainEdge> pairs, singles;
    std::vector<std::uint32_t> uncertain; ///< casting caps with facing 0
};

/// The boundary of a batch's triangles, each signed by the side from which a light sees it.
class CasterChain {
  public:
    /// Linear in the caps. `shadow` must outlive this.
    explicit CasterChain(const PlanePairShadow& shadow) : shadow_(&shadow), facings_(shadow) {}

    /// Fills in `facings`, one per cap (CasterFacings), and `seen`, and reuses their memory.
    /// `range`: as of rangeInObject().
    void look(const LightInBatch& light, double range, std::vector<std::int8_t>& facings,
              SeenCasters& seen) const;

    /// All caps within range of a point light that a ray from it may meet, and neighbours of these.
    /// `direction`: in the batch's space.
    std::vector<std::uint32_t> capsAlong(const LightInBatch& light, const glm::dvec3& direction,
                                         double range) const;

    const PlanePairShadow& shadow() const { return *shadow_; }
    /// The largest magnitude of a coordinate.
    double size() const { return facings_.size(); }

  private:
    const PlanePairShadow* shadow_;
    CasterFacings facings_;
};

} // namespace edgeshade
