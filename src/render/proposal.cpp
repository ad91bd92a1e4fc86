#include "src/render/proposal.hpp"

namespace edgeshade {
namespace {

int facingOf(const std::vector<std::int8_t>& facings, PlaneOf plane) {
    const int facing = facings[plane.cap()];
    return plane.negated() ? -facing : facing;
}

} // namespace

void propose(const AdaptedShadow& shadow, const LightFacings& facings, const LightBall& ball,
             int mantissaBits, Proposal& proposal) {
    facings.find(ball, mantissaBits, proposal.facings);
    proposal.pairs.resize(shadow.pairs.size());
    proposal.ofCluster.clear();
    std::uint32_t listed = 0;
    for (const ShadowCluster& cluster : shadow.clusters) {
        const std::uint32_t first = listed;
        for (std::uint32_t i = cluster.pairs.first; i < cluster.pairs.end(); ++i) {
            const auto& [plane0, plane1] = shadow.pairPlanes[i];
            const int facing0 = facingOf(proposal.facings, plane0);
            const int facing1 = facingOf(proposal.facings, plane1);
            proposal.pairs[listed] = i; // written over unless it counts: no branch to mispredict
            listed += facing0 == 0 || facing0 != facing1;
        }
        proposal.ofCluster.push_back({first, listed - first});
    }
    proposal.pairs.resize(listed);
}

} // namespace edgeshade
