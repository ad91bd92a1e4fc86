#include "src/shadow/layers/caster_chain.hpp"

#include "preprocess/volumes/clustering.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace edgeshade {
namespace {

/// Room around boxes for rays in double, as a share of the coordinates.
constexpr double rayRoom = 1e-6;

/// Fills in the facings of a cluster's triangles as PlaneOf::bits names them: each and its
/// opposite.
void addSigned(const std::vector<std::int8_t>& facings, const RecordRange& caps,
               std::vector<std::int8_t>& signedFacings) {
    const std::int8_t* const from = facings.data();
    std::int8_t* const to = signedFacings.data();
    for (std::uint32_t cap = caps.first; cap < caps.end(); ++cap) {
        to[2 * cap] = from[cap];
        to[2 * cap + 1] = static_cast<std::int8_t>(-from[cap]);
    }
}

/// Appends without branches: each edge is overwritten by the next unless its weight isn't 0.
class EdgeAppender {
  public:
    explicit EdgeAppender(std::vector<ChainEdge>& edges) : edges_(edges) {}

    template <class WeightOf>
    void append(const RecordRange& records, WeightOf weightOf) {
        for (std::uint32_t first = records.first; first < records.end(); first += atOnce) {
            const std::uint32_t end = std::min(first + atOnce, records.end());
            if (edges_.size() < size_ + atOnce) edges_.resize(2 * size_ + atOnce);
            ChainEdge* next = edges_.data() + size_;
            for (std::uint32_t i = first; i < end; ++i) {
                const int weight = weightOf(i);
                *next = {i, weight};
                next += weight != 0 ? 1 : 0;
            }
            size_ = static_cast<std::size_t>(next - edges_.data());
        }
    }
    /// Call this last.
    void end() { edges_.resize(size_); }

  private:
    static constexpr std::uint32_t atOnce = 256; ///< records; few of them have an edge

    std::vector<ChainEdge>& edges_;
    std::size_t size_ = 0;
};

/// Calls use(cap) with each cap of the range whose facing is 0.
template <class Use>
void forUncertain(const std::vector<std::int8_t>& facings, const RecordRange& caps, Use use) {
    const std::int8_t* const all = facings.data();
    for (std::uint32_t cap = caps.first; cap < caps.end(); ++cap) {
        const void* const zero = std::memchr(all + cap, 0, caps.end() - cap);
        if (!zero) return;
        cap = static_cast<std::uint32_t>(static_cast<const std::int8_t*>(zero) - all);
        use(cap);
    }
}

/// A ray, for tests of boxes.
class BoxRay {
  public:
    BoxRay(const glm::dvec3& origin, const glm::dvec3& direction, double room)
        : origin_(origin), room_(room) {
        for (glm::length_t axis = 0; axis < 3; ++axis)
            perStep_[axis] = 1.0 / (direction[axis] != 0.0 ? direction[axis] : 1e-300);
    }

    bool mayMeet(const Box& box) const {
        const glm::dvec3 low = (box.low - room_ - origin_) * perStep_;
        const glm::dvec3 high = (box.high + room_ - origin_) * perStep_;
        const glm::dvec3 enter = glm::min(low, high), leave = glm::max(low, high);
        const double first = std::max({enter.x, enter.y, enter.z, 0.0});
        return !(first > std::min({leave.x, leave.y, leave.z}));
    }

  private:
    glm::dvec3 origin_, perStep_;
    double room_;
};

} // namespace

bool CasterReach::mayHold(const Box& box, const LightInBatch& light) const {
    return !isBeyond(box, glm::dvec3(light.place), range + light.rounding) &&
           std::none_of(planes.begin(), planes.end(),
                        [&](const glm::dvec4& plane) { return isOutside(box, plane); });
}

CasterChain::CasterChain(const PlanePairShadow& shadow) : shadow_(&shadow), facings_(shadow) {
    for (const ShadowCluster& cluster : shadow.clusters)
        for (const glm::dvec3& corner : {cluster.bounds.low, cluster.bounds.high})
            bounds_.add(corner);
}

void CasterChain::look(const LightInBatch& light, const CasterReach& reach,
                       std::vector<std::int8_t>& facings, SeenCasters& seen) const {
    const PlanePairShadow& shadow = *shadow_;
    facings_.find(light, facings);
    seen.uncertain.clear();
    if (seen.signedFacings.size() < 2 * facings.size())
        seen.signedFacings.resize(2 * facings.size());
    const std::int8_t* const signedOf = seen.signedFacings.data();
    const auto* const ofPair = shadow.pairPlanes.data();
    const PlaneOf* const ofSingle = shadow.singlePlanes.data();
    EdgeAppender pairs(seen.pairs), singles(seen.singles);
    seen.clusters.clear();
    for (const ShadowCluster& cluster : shadow.clusters) {
        if (!reach.mayHold(cluster.bounds, light)) continue;
        seen.clusters.push_back(&cluster);
        addSigned(facings, cluster.caps, seen.signedFacings);
    }
    for (const ShadowCluster* const of : seen.clusters) {
        const ShadowCluster& cluster = *of;
        pairs.append(cluster.pairs, [=](std::uint32_t i) {
            return signedOf[ofPair[i][0].bits] - signedOf[ofPair[i][1].bits];
        });
        singles.append(cluster.singles,
                       [=](std::uint32_t i) { return signedOf[ofSingle[i].bits]; });
        forUncertain(facings, cluster.caps, [&](std::uint32_t cap) {
            if (shadow.caps[cap].casts()) seen.uncertain.push_back(cap);
        });
    }
    pairs.end();
    singles.end();
}

std::vector<std::uint32_t> CasterChain::capsAlong(const LightInBatch& light,
                                                  const glm::dvec3& direction,
                                                  const CasterReach& reach) const {
    const BoxRay ray(glm::dvec3(light.place), direction,
                     rayRoom * (light.length() + size()) + light.rounding);
    std::vector<std::uint32_t> caps;
    for (const ShadowCluster& cluster : shadow_->clusters) {
        if (!reach.mayHold(cluster.bounds, light) || !ray.mayMeet(cluster.bounds)) continue;
        for (std::uint32_t leaf = 0; leaf < cluster.leaves.count; ++leaf) {
            if (!ray.mayMeet(shadow_->leaves[cluster.leaves.first + leaf])) continue;
            const std::uint32_t first = cluster.caps.first + leaf * leafTriangles;
            const std::uint32_t end = std::min(first + leafTriangles, cluster.caps.end());
            for (std::uint32_t cap = first; cap < end; ++cap)
                caps.push_back(cap);
        }
    }
    return caps;
}

} // namespace edgeshade
