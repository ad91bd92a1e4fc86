#pragma once

#include "src/shadow/layers/caster_facings.hpp"

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
    // Scratch.
    std::vector<const ShadowCluster*> clusters{}; ///< within reach
    std::vector<std::int8_t> signedFacings{};     ///< their facings, by PlaneOf::bits
};

/// The boundary of a batch's triangles, each signed by the side from which a light sees it.
class CasterChain {
  public:
    /// Linear in the caps. `shadow` must outlive this.
    explicit CasterChain(const PlanePairShadow& shadow);

    /// Fills in `facings`, one per cap (CasterFacings), and `seen`, and reuses their memory.
    void look(const LightInBatch& light, const CasterReach& reach,
              std::vector<std::int8_t>& facings, SeenCasters& seen) const;

    /// All caps within reach that a ray from a point light may meet, and neighbours of these.
    /// `direction`: in the batch's space.
    std::vector<std::uint32_t> capsAlong(const LightInBatch& light, const glm::dvec3& direction,
                                         const CasterReach& reach) const;

    const PlanePairShadow& shadow() const { return *shadow_; }
    /// Around all casters.
    const Box& bounds() const { return bounds_; }
    /// The largest magnitude of a coordinate.
    double size() const { return facings_.size(); }

  private:
    const PlanePairShadow* shadow_;
    CasterFacings facings_;
    Box bounds_;
};

} // namespace edgeshade
