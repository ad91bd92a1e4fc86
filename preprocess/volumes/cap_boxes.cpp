#include "preprocess/volumes/cap_boxes.hpp"

#include "preprocess/volumes/clustering.hpp"

#include <algorithm>

namespace edgeshade {

Box boxOf(const std::vector<CapRecord>& caps, std::size_t first, std::size_t end) {
    glm::vec3 low = caps[first].a, high = low;
    for (std::size_t i = first; i < end; ++i)
        for (const glm::vec3* corner : {&caps[i].a, &caps[i].b, &caps[i].c}) {
            low = glm::min(low, *corner);
            high = glm::max(high, *corner);
        }
    Box box;
    box.add(glm::dvec3(low));
    box.add(glm::dvec3(high));
    return box;
}

void addLeaves(Threads threads, PlanePairShadow& shadow) {
    std::vector<RecordRange> capsOf; // by leaf
    for (const ShadowCluster& cluster : shadow.clusters)
        for (std::uint32_t cap = cluster.caps.first; cap < cluster.caps.end(); cap += leafTriangles)
            capsOf.push_back({cap, std::min(leafTriangles, cluster.caps.end() - cap)});
    shadow.leaves.resize(capsOf.size());
    forEachItem(capsOf.size(), itemsOfThread / leafTriangles, threads, [&](std::size_t i) {
        shadow.leaves[i] = boxOf(shadow.caps, capsOf[i].first, capsOf[i].end());
    });
}

} // namespace edgeshade
