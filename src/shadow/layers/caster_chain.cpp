#include "src/shadow/layers/caster_chain.hpp"

#include "preprocess/volumes/clustering.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace edgeshade {
namespace {

/// Room around boxes for rays in double, as a share of the coordinates.
constexpr double rayRoom = 1e-6;

constexpr std::uint32_t recordsPerRun = 32; // at most 255

/// A plane's facing.
int facingOf(const std::int8_t* facings, PlaneOf plane) {
    const int facing = facings[plane.cap()];
    return plane.negated() ? -facing : facing;
}

/// The sum of the facings of a record's triangles, each negated if it runs from b to a.
int weightOf(const std::int8_t* facings, const std::array<PlaneOf, 2>& planes) {
    return facingOf(facings, planes[0]) - facingOf(facings, planes[1]);
}
int weightOf(const std::int8_t* facings, PlaneOf plane) {
    return facingOf(facings, plane);
}

std::span<const PlaneOf> planesOf(const std::array<PlaneOf, 2>& planes) {
    return planes;
}
std::span<const PlaneOf> planesOf(const PlaneOf& plane) {
    return {&plane, 1};
}

/// Divides the records of one kind into runs. `planes`: of all records.
template <class Planes>
RecordRuns runsOf(const PlanePairShadow& shadow, RecordRange ShadowCluster::*records,
                  const std::vector<Planes>& planes) {
    RecordRuns all;
    // By run of caps: one more than the last run of records that has it.
    std::vector<std::size_t> lastRun(shadow.caps.size() / FollowedFacings::run + 1, 0);
    for (const ShadowCluster& cluster : shadow.clusters) {
        const RecordRange& of = cluster.*records;
        const auto first = static_cast<std::uint32_t>(all.runs.size());
        for (std::uint32_t at = of.first; at < of.end(); at += recordsPerRun) {
            RecordRuns::Run run{{at, std::min(recordsPerRun, of.end() - at)},
                                {static_cast<std::uint32_t>(all.capRuns.size()), 0}};
            for (std::uint32_t i = at; i < run.records.end(); ++i)
                for (const PlaneOf plane : planesOf(planes[i])) {
                    const std::size_t capRun = plane.cap() / FollowedFacings::run;
                    if (lastRun[capRun] == all.runs.size() + 1) continue;
                    lastRun[capRun] = all.runs.size() + 1;
                    all.capRuns.push_back(static_cast<std::uint32_t>(capRun));
                }
            run.capRuns.count = static_cast<std::uint32_t>(all.capRuns.size()) - run.capRuns.first;
            all.runs.push_back(run);
        }
        all.ofCluster.push_back({first, static_cast<std::uint32_t>(all.runs.size()) - first});
    }
    return all;
}

/// Finds the chain's edges among the records of one kind, run by run.
template <class Planes>
class EdgeSearch {
  public:
    EdgeSearch(const RecordRuns& runs, const std::vector<Planes>& planes,
               const FollowedFacings& facings, FollowedEdges& followed,
               std::vector<ChainEdge>& seen)
        : runs_(runs), planes_(planes), facings_(facings), followed_(followed), seen_(seen) {
        followed.edges.resize(planes.size());
        followed.count.resize(runs.runs.size());
        followed.foundAt.resize(runs.runs.size());
        seen.clear();
    }

    void addCluster(std::size_t cluster) {
        const RecordRange& runs = runs_.ofCluster[cluster];
        for (std::uint32_t run = runs.first; run < runs.end(); ++run) {
            const RecordRuns::Run& of = runs_.runs[run];
            if (mayHaveChanged(of, followed_.foundAt[run])) find(run);
            if (followed_.count[run] == 0) continue; // most of them
            const ChainEdge* const first = followed_.edges.data() + of.records.first;
            seen_.insert(seen_.end(), first, first + followed_.count[run]);
        }
    }

  private:
    bool mayHaveChanged(const RecordRuns::Run& run, std::uint32_t since) const {
        std::uint32_t latest = 0;
        for (std::uint32_t i = run.capRuns.first; i < run.capRuns.end(); ++i)
            latest = std::max(latest, facings_.changedAt[runs_.capRuns[i]]);
        return latest > since;
    }

    void find(std::uint32_t run) {
        const RecordRange& records = runs_.runs[run].records;
        const std::int8_t* const facings = facings_.facings.data();
        ChainEdge* const first = followed_.edges.data() + records.first;
        ChainEdge* next = first;
        // Without branches: each edge is overwritten by the next unless its weight isn't 0.
        for (std::uint32_t i = records.first; i < records.end(); ++i) {
            const int weight = weightOf(facings, planes_[i]);
            *next = {i, weight};
            next += weight != 0 ? 1 : 0;
        }
        followed_.count[run] = static_cast<std::uint8_t>(next - first);
        followed_.foundAt[run] = facings_.look;
    }

    const RecordRuns& runs_;
    const std::vector<Planes>& planes_;
    const FollowedFacings& facings_;
    FollowedEdges& followed_;
    std::vector<ChainEdge>& seen_;
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

CasterChain::CasterChain(const PlanePairShadow& shadow)
    : shadow_(&shadow), facings_(shadow),
      pairs_(runsOf(shadow, &ShadowCluster::pairs, shadow.pairPlanes)),
      singles_(runsOf(shadow, &ShadowCluster::singles, shadow.singlePlanes)), vertices_(shadow) {
    for (const ShadowCluster& cluster : shadow.clusters)
        for (const glm::dvec3& corner : {cluster.bounds.low, cluster.bounds.high})
            bounds_.add(corner);
}

void CasterChain::look(const LightInBatch& light, const CasterReach& reach, FollowedChain& followed,
                       SeenCasters& seen) const {
    const PlanePairShadow& shadow = *shadow_;
    facings_.follow(light, followed.casters);
    const FollowedFacings& facings = followed.casters.facings;
    EdgeSearch pairs(pairs_, shadow.pairPlanes, facings, followed.pairs, seen.pairs);
    EdgeSearch singles(singles_, shadow.singlePlanes, facings, followed.singles, seen.singles);
    seen.uncertain.clear();
    for (std::size_t i = 0; i < shadow.clusters.size(); ++i) {
        const ShadowCluster& cluster = shadow.clusters[i];
        if (!reach.mayHold(cluster.bounds, light)) continue;
        pairs.addCluster(i);
        singles.addCluster(i);
        forUncertain(facings.facings, cluster.caps, [&](std::uint32_t cap) {
            if (shadow.caps[cap].casts()) seen.uncertain.push_back(cap);
        });
    }
}

void CasterChain::findCapsAlong(const LightInBatch& light, const glm::dvec3& direction,
                                const CasterReach& reach, std::vector<std::uint32_t>& caps) const {
    caps.clear();
    const BoxRay ray(glm::dvec3(light.place), direction,
                     rayRoom * (light.length() + size()) + light.rounding);
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
}

} // namespace edgeshade
