#pragma once

#include "src/render/light_facings.hpp"

namespace edgeshade {

/// The records of a batch that can be silhouettes in some light of a ball, and more (method,
/// section 6.8): every pair that is not in the list has multiplicity 0 in all of them, whichever of
/// its triangles count. Single records are silhouettes in any light but one in their plane, so none
/// is left out. The vertex shader alone judges what is in the list.
struct Proposal {
    std::vector<std::uint32_t> pairs;   ///< of AdaptedShadow::pairs, ascending
    std::vector<RecordRange> ofCluster; ///< ranges of `pairs`, by cluster
    std::vector<std::int8_t> facings;   ///< of caps, see LightFacings
};

/// Fills in `proposal`, whose memory it uses again. `facings` must be those of the shadow.
void propose(const AdaptedShadow& shadow, const LightFacings& facings, const LightBall& ball,
             int mantissaBits, Proposal& proposal);

} // namespace edgeshade
