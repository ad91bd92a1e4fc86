#pragma once

#include "src/shadow/silhouette/light_facings.hpp"

#include <limits>
#include <memory>

namespace edgeshade {

/// Some of a batch's pairs.
struct PairList {
    std::vector<std::uint32_t> pairs;   ///< of PlanePairShadow::pairs, ascending
    std::vector<RecordRange> ofCluster; ///< ranges of `pairs`, by cluster
};

/// The records of a batch that can be silhouettes in some light of a ball, and more
/// (docs/method.md, C24): every pair that is not listed has multiplicity 0 in all of them,
/// whichever of its triangles count. Single records are silhouettes in any light but one in their
/// plane, so none is left out. The vertex shader alone judges what is listed.
struct SilhouetteList {
    PairList certain;   ///< silhouettes in any light of the ball: multiplicity ±2 if all count
    PairList uncertain; ///< silhouettes in some, maybe
    std::vector<std::int8_t> facings; ///< of caps, see LightFacings
    bool lightInPlane = true; ///< the light may be in the plane of an uncertain pair's triangle
    /// Tells this list from any other, also from one at the same address later.
    std::shared_ptr<const int> identity = nullptr;

    std::size_t size() const { return certain.pairs.size() + uncertain.pairs.size(); }
};

/// The listed records themselves; `records` is emptied first.
void gatherPairs(const PlanePairShadow& shadow, const PairList& list,
                 std::vector<PairRecord>& records);

/// Whether the light may be in the plane of a listed triangle, or within `reach` of it, as floats
/// of so many mantissa bits round. If not, every listed pair of which both triangles cast has
/// multiplicity 0 or ±2.
bool isInSomePlane(const PlanePairShadow& shadow, const PairList& list, const glm::vec4& light,
                   float reach, int mantissaBits);

/// How many caps of a cluster may face the light.
std::uint32_t lightFacingCapCount(const SilhouetteList& proposal, const ShadowCluster& cluster);

/// Whether a cap with this facing, of SilhouetteList::facings, may face the light.
inline bool mayFaceTheLight(std::int8_t facing) {
    return facing >= 0;
}

/// Fills in `proposal`, whose memory it uses again. `facings` must be those of the shadow. `range`:
/// as rangeInObject() has it; pairs of clusters out of it, for all lights of the ball, are not
/// listed, and no memory is kept for them.
void listSilhouettes(const PlanePairShadow& shadow, const LightFacings& facings,
                     const LightBall& ball, int mantissaBits, SilhouetteList& proposal,
                     double range = std::numeric_limits<double>::infinity());

} // namespace edgeshade
