#include "src/shadow/silhouette/plane_lanes.hpp"

#include "src/shadow/silhouette/lanes.hpp"

namespace edgeshade {

using namespace silhouette;

void PlaneLanes::gather(const PlanePairShadow& shadow, const PairList& list,
                        std::vector<std::uint8_t>& taken) {
    for (auto* component : {&x_, &y_, &z_, &w_}) {
        component->clear();
        component->reserve(2 * list.pairs.capacity() + lanes); // with the list's room for more
    }
    const auto add = [&](const glm::vec4& plane) {
        x_.push_back(plane.x);
        y_.push_back(plane.y);
        z_.push_back(plane.z);
        w_.push_back(plane.w);
    };
    taken.assign(shadow.caps.size(), 0);
    for (const std::uint32_t pair : list.pairs)
        for (const PlaneOf plane : shadow.pairPlanes[pair]) {
            if (taken[plane.cap()] != 0) continue;
            taken[plane.cap()] = 1;
            add(shadow.caps[plane.cap()].plane); // negated or not, the same
        }
    while (x_.size() % lanes != 0)
        add({x_.back(), y_.back(), z_.back(), w_.back()});
}

bool PlaneLanes::mayHold(const glm::vec4& light, float reach, int mantissaBits) const {
    const float share = static_cast<float>(dotRounding(mantissaBits));
    const Floats least = all(reach * (1.0f + share) + dotUnderflow(mantissaBits));
    const Floats lightX = all(light.x), lightY = all(light.y), lightZ = all(light.z),
                 lightW = all(light.w);
    constexpr std::size_t block = 16 * lanes; // between two looks at the result
    for (std::size_t first = 0; first < x_.size(); first += block) {
        Ints beside = {-1, -1, -1, -1};
        const std::size_t end = std::min(first + block, x_.size());
        for (std::size_t i = first; i < end; i += lanes) {
            const Floats x = load(x_, i) * lightX, y = load(y_, i) * lightY,
                         z = load(z_, i) * lightZ, w = load(w_, i) * lightW;
            const Floats side = x + y + z + w;
            const Floats size = magnitude(x) + magnitude(y) + magnitude(z) + magnitude(w);
            beside &= magnitude(side) > least + all(share) * size; // false for what is no number
        }
        if ((beside[0] & beside[1] & beside[2] & beside[3]) == 0) return true;
    }
    return false;
}

} // namespace edgeshade
