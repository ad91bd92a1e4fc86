#include "src/shadow/silhouette/silhouette_list.hpp"

#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

int facingOf(const std::vector<std::int8_t>& facings, PlaneOf plane) {
    const int facing = facings[plane.cap()];
    return plane.negated() ? -facing : facing;
}

/// Whether planeSide() may be 0; evaluated in floats like LightFacings, and true on overflow.
bool mayBeIn(const glm::vec4& plane, const glm::vec4& light, float reach, int mantissaBits) {
    const glm::vec4 terms = plane * light;
    const glm::vec4 sizes = glm::abs(terms);
    const float side = terms.x + terms.y + terms.z + terms.w;
    const float size = sizes.x + sizes.y + sizes.z + sizes.w;
    const float share = static_cast<float>(dotRounding(mantissaBits));
    return !(std::abs(side) > reach * (1.0f + share) + dotUnderflow(mantissaBits) + share * size);
}

/// Appends to a list without a branch to mispredict: each entry is overwritten by the next unless
/// it counts.
class Appender {
  public:
    Appender(PairList& list, std::size_t most) : list_(list) {
        list_.pairs.resize(most);
        list_.ofCluster.clear();
    }

    void append(std::uint32_t pair, bool counts) {
        list_.pairs[size_] = pair;
        size_ += counts;
    }
    void endCluster() {
        list_.ofCluster.push_back({first_, size_ - first_});
        first_ = size_;
    }
    void end() { list_.pairs.resize(size_); }

  private:
    PairList& list_;
    std::uint32_t first_ = 0, size_ = 0;
};

} // namespace

void gatherPairs(const PlanePairShadow& shadow, const PairList& list,
                 std::vector<PairRecord>& records) {
    records.clear();
    records.reserve(list.pairs.size());
    for (const std::uint32_t pair : list.pairs)
        records.push_back(shadow.pairs[pair]);
}

bool isInSomePlane(const PlanePairShadow& shadow, const PairList& list, const glm::vec4& light,
                   float reach, int mantissaBits) {
    return std::any_of(list.pairs.begin(), list.pairs.end(), [&](std::uint32_t pair) {
        return mayBeIn(shadow.pairs[pair].plane0, light, reach, mantissaBits) ||
               mayBeIn(shadow.pairs[pair].plane1, light, reach, mantissaBits);
    });
}

std::uint32_t lightFacingCapCount(const SilhouetteList& proposal, const ShadowCluster& cluster) {
    const auto first = proposal.facings.begin() + cluster.caps.first;
    return static_cast<std::uint32_t>(
        std::count_if(first, first + cluster.caps.count, mayFaceTheLight));
}

void listSilhouettes(const PlanePairShadow& shadow, const LightFacings& facings,
                     const LightBall& ball, int mantissaBits, SilhouetteList& proposal,
                     double range) {
    facings.find(ball, mantissaBits, proposal.facings);
    Appender certain(proposal.certain, shadow.pairs.size());
    Appender uncertain(proposal.uncertain, shadow.pairs.size());
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
    }
    certain.end();
    uncertain.end();
    if (!std::isfinite(range)) return;
    for (PairList* list : {&proposal.certain, &proposal.uncertain})
        list->pairs.shrink_to_fit();
}

} // namespace edgeshade
