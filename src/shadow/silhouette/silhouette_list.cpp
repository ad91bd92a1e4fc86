#include "src/shadow/silhouette/silhouette_list.hpp"

#include "src/shadow/lights/light_range.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

int facingOf(const std::vector<std::int8_t>& facings, PlaneOf plane) {
    const int facing = facings[plane.cap()];
    return plane.negated() ? -facing : facing;
}

constexpr std::uint32_t leastRoom = 64; // pairs that a list has room for, if it may get as many

/// Number of a cluster's caps that may face the light.
std::uint32_t lightFacingCaps(const std::vector<std::int8_t>& facings, const RecordRange& caps) {
    std::uint32_t count = 0; // of the result's type, so that compilers vectorise the sum
    for (std::uint32_t i = caps.first; i < caps.end(); ++i)
        count += mayFaceTheLight(facings[i]) ? 1 : 0;
    return count;
}

/// Gathers a list in `memory`, without a branch to mispredict: each entry is overwritten by the
/// next unless it counts.
class Appender {
  public:
    Appender(PairList& list, std::size_t most, std::vector<std::uint32_t>& memory)
        : list_(list), memory_(memory) {
        if (memory_.size() < most) memory_.resize(most);
        list_.ofCluster.clear();
    }

    void append(std::uint32_t pair, bool counts) {
        memory_[size_] = pair;
        size_ += counts;
        ++offered_;
    }
    void endCluster() {
        list_.ofCluster.push_back({first_, size_ - first_});
        first_ = size_;
    }
    void end() {
        // Room for lists of the light's next places, which may be longer.
        const std::uint32_t room = offered_ / 8 + leastRoom;
        if (list_.pairs.capacity() < std::min(offered_, std::max(size_, room)))
            list_.pairs.reserve(std::min(offered_, std::max(size_ + size_ / 2, room)));
        list_.pairs.assign(memory_.begin(), memory_.begin() + size_);
    }

  private:
    PairList& list_;
    std::vector<std::uint32_t>& memory_;
    std::uint32_t first_ = 0, size_ = 0, offered_ = 0;
};

} // namespace

void gatherPairs(const PlanePairShadow& shadow, const PairList& list,
                 std::vector<PairRecord>& records) {
    records.clear();
    records.reserve(list.pairs.size());
    for (const std::uint32_t pair : list.pairs)
        records.push_back(shadow.pairs[pair]);
}

void listSilhouettes(const PlanePairShadow& shadow, const LightFacings& facings,
                     const LightBall& ball, int mantissaBits, SilhouetteList& proposal,
                     double range, ListMemory& memory) {
    facings.find(ball, mantissaBits, proposal.facings);
    Appender certain(proposal.certain, shadow.pairs.size(), memory.certain);
    Appender uncertain(proposal.uncertain, shadow.pairs.size(), memory.uncertain);
    proposal.lightFacingCaps.clear();
    const glm::dvec3 center(ball.center);
    for (const ShadowCluster& cluster : shadow.clusters) {
        const bool reached = !isBeyond(cluster.bounds, center, range + ball.radius);
        for (std::uint32_t i = cluster.pairs.first; reached && i < cluster.pairs.end(); ++i) {
            const auto& [plane0, plane1] = shadow.pairPlanes[i];
            const int product =
                facingOf(proposal.facings, plane0) * facingOf(proposal.facings, plane1);
            certain.append(i, product < 0);
            uncertain.append(i, product == 0);
        }
        certain.endCluster();
        uncertain.endCluster();
        proposal.lightFacingCaps.push_back(lightFacingCaps(proposal.facings, cluster.caps));
    }
    certain.end();
    uncertain.end();
}

} // namespace edgeshade
