#include "src/shadow/irregular/light_space.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// The border of a face's rays, with a margin for rounding.
constexpr float faceEnd = 1.0f + 1e-5f;

} // namespace

LightSpace::LightSpace(const Light& light, const glm::dvec3& near)
    : directional_(light.position.w == 0.0),
      origin_(directional_ ? near : glm::dvec3(light.position)) {
    if (!directional_) return;
    const glm::dvec3 away = -unitOf(glm::dvec3(light.position));
    const auto across = axesAlong(away);
    turn_ = glm::transpose(glm::dmat3(across[0], across[1], away));
}

glm::dmat4 LightSpace::fromBatch(const glm::dmat4& worldFromBatch) const {
    glm::dmat4 near = worldFromBatch;
    near[3] -= glm::dvec4(origin_, 0.0);
    return glm::dmat4(turn_) * near;
}

FaceExtent LightSpace::extentIn(std::size_t face, const LightBox& box) const {
    if (box.empty()) return {};
    if (directional_) return {glm::vec2(box.low), glm::vec2(box.high), box.low.z, box.high.z};
    const auto axis = static_cast<glm::length_t>(face / 2);
    const bool negative = face % 2 != 0;
    const float farthest = negative ? -box.low[axis] : box.high[axis];
    const float nearest = negative ? -box.high[axis] : box.low[axis];
    if (farthest <= 0.0f) return {};
    FaceExtent extent{glm::vec2(-faceEnd), glm::vec2(faceEnd), std::max(nearest, 0.0f), farthest};
    for (glm::length_t i = 0; i < 2; ++i) {
        const float low = box.low[(axis + 1 + i) % 3], high = box.high[(axis + 1 + i) % 3];
        if (low > faceEnd * farthest || high < -faceEnd * farthest) return {};
        if (nearest <= 0.0f) continue;
        const float rayLow = std::min(low / nearest, low / farthest);
        const float rayHigh = std::max(high / nearest, high / farthest);
        if (rayLow > faceEnd || rayHigh < -faceEnd) return {};
        extent.low[i] = std::max(extent.low[i], rayLow - faceEnd + 1.0f);
        extent.high[i] = std::min(extent.high[i], rayHigh + faceEnd - 1.0f);
    }
    return extent;
}

} // namespace edgeshade
