#pragma once

#include "src/shadow/silhouette/light_facings.hpp"

#include <limits>
#include <memory>

namespace edgeshade {

/// Some of a batch's pairs.
struct PairList {
    std::vector<std::uint32_t> pairs;   ///< indices in PlanePairShadow::pairs, ascending
    std::vector<RecordRange> ofCluster; ///< ranges of `pairs`, by cluster
};

/// The records of a batch that can be silhouettes for some light of a ball, and perhaps others
/// (docs/method.md, C24). Every pair that is not listed has multiplicity 0 for all of these lights,
/// whichever of its triangles count. Single records are silhouettes for any light outside their
/// plane, so none is omitted. The vertex shader decides about the listed records.
struct SilhouetteList {
    PairList certain;   ///< silhouettes for every light of the ball: multiplicity ±2 if all count
    PairList uncertain; ///< silhouettes for some, perhaps
    std::vector<std::int8_t> facings; ///< one per cap, see LightFacings
    /// By cluster: number of caps that may face the light.
    std::vector<std::uint32_t> lightFacingCaps;
    bool lightInPlane = true; ///< the light may be in the plane of an uncertain pair's triangle
    /// Identifies the list of a light and a batch, even if a later one has the same address.
    std::shared_ptr<const int> identity = nullptr;
    std::size_t version = 0; ///< how often it was made again

    std::size_t size() const { return certain.pairs.size() + uncertain.pairs.size(); }
};

/// Copies the listed records to `records`, which is emptied first.
void gatherPairs(const PlanePairShadow& shadow, const PairList& list,
                 std::vector<PairRecord>& records);

/// Whether a cap with this facing, of SilhouetteList::facings, may face the light.
inline bool mayFaceTheLight(std::int8_t facing) {
    return facing >= 0;
}

/// Arrays that listing uses again for the next list.
struct ListMemory {
    std::vector<std::uint32_t> certain, uncertain;
};

/// Fills in `proposal`, and reuses its memory. `facings` must be those of the shadow. `range`: as
/// of rangeInObject(); pairs of clusters beyond it, for all lights of the ball, are not listed.
/// Lists have room for half as many pairs more, at least for an eighth of those that the range
/// reaches.
void listSilhouettes(const PlanePairShadow& shadow, const LightFacings& facings,
                     const LightBall& ball, int mantissaBits, SilhouetteList& proposal,
                     double range, ListMemory& memory);

} // namespace edgeshade
