#include "src/shadow/plan/solid_clusters.hpp"

#include "preprocess/mesh/solid_components.hpp"

#include <algorithm>
#include <span>

namespace edgeshade {
namespace {

bool areSolids(std::span<const CapRecord> caps) {
    const WeldedMesh mesh = weldCaps(caps);
    const EdgeList edges = buildEdges(mesh);
    const auto solid = solidComponents(mesh, edges, findComponents(mesh, edges));
    return !solid.empty() &&
           std::all_of(solid.begin(), solid.end(), [](auto of) { return of != 0; });
}

bool isOfSolids(const PlanePairShadow& shadow, const ShadowCluster& cluster) {
    return cluster.closed && cluster.singleSided != 0 &&
           areSolids(std::span(shadow.caps).subspan(cluster.caps.first, cluster.caps.count));
}

} // namespace

std::vector<std::uint8_t> findSolids(const PlanePairShadow& shadow) {
    // Any pose may cross itself, and the next pose would need a new test.
    if (shadow.vertices) return std::vector<std::uint8_t>(shadow.clusters.size(), 0);
    std::vector<std::uint8_t> solids;
    for (const ShadowCluster& cluster : shadow.clusters)
        solids.push_back(isOfSolids(shadow, cluster));
    return solids;
}

const std::vector<std::uint8_t>&
KeptSolids::of(const std::shared_ptr<const PlanePairShadow>& shadow) {
    if (shadow->solids) return *shadow->solids;
    const auto found = entries_.find(shadow.get());
    if (found != entries_.end() && found->second.shadow.lock() == shadow)
        return found->second.solids;
    std::erase_if(entries_, [](const auto& entry) { return entry.second.shadow.expired(); });
    return entries_.insert_or_assign(shadow.get(), Entry{shadow, findSolids(*shadow)})
        .first->second.solids;
}

} // namespace edgeshade
