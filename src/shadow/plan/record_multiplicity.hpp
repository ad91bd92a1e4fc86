#pragma once

#include "src/shadow/plan/volume_plan.hpp"

#include <algorithm>

namespace edgeshade {

/// countedSide() of the shaders, in the processor's floats: only for estimates.
inline int countedSideOf(const glm::vec4& plane, const glm::vec4& light, Counted counted) {
    const float side =
        plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    const int sign = (side > 0.0f) - (side < 0.0f);
    if (counted == Counted::lightFacing) return std::max(sign, 0);
    return counted == Counted::facingAway ? std::min(sign, 0) : sign;
}

inline int multiplicityOf(const PairRecord& record, const glm::vec4& light, Counted counted) {
    return countedSideOf(record.plane0, light, counted) -
           countedSideOf(record.plane1, light, counted);
}

inline int multiplicityOf(const SingleRecord& record, const glm::vec4& light, Counted counted) {
    return countedSideOf(record.plane, light, counted);
}

} // namespace edgeshade
