#include "src/shadow/plan/contact_caps.hpp"

#include "preprocess/volumes/clustering.hpp"
#include "src/shadow/lights/light_contact.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

bool ContactCaps::anyOf(const RecordRange& range) const {
    const auto first = std::lower_bound(caps.begin(), caps.end(), range.first);
    return first != caps.end() && *first < range.end();
}

void findContactCaps(const PlanePairShadow& shadow, const glm::dvec4& light, int mantissaBits,
                     ContactCaps& contacts) {
    contacts.caps.clear();
    contacts.reach = 0.0f;
    if (light.w == 0.0) return;
    double reach = 0.0;
    for (const ShadowCluster& cluster : shadow.clusters) {
        if (!mayTouch(cluster.bounds, light, mantissaBits)) continue;
        for (std::uint32_t leaf = 0; leaf < cluster.leaves.count; ++leaf) {
            if (!mayTouch(shadow.leaves[cluster.leaves.first + leaf], light, mantissaBits))
                continue;
            const std::uint32_t first = cluster.caps.first + leaf * leafTriangles;
            const std::uint32_t end = std::min(first + leafTriangles, cluster.caps.end());
            for (std::uint32_t i = first; i < end; ++i) {
                const CapRecord& cap = shadow.caps[i];
                const LightContact contact = contactOf({cap.a, cap.b, cap.c}, light, mantissaBits);
                if (!contact.touches) continue;
                contacts.caps.push_back(i);
                reach = std::max(reach, contact.reach);
            }
        }
    }
    contacts.reach = std::nextafter(static_cast<float>(reach), INFINITY);
    if (contacts.caps.empty()) contacts.reach = 0.0f;
    std::sort(contacts.caps.begin(), contacts.caps.end());
}

} // namespace edgeshade
