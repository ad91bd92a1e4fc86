#include "src/shadow/silhouette/light_facings.hpp"

#include "src/shadow/silhouette/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace edgeshade {
namespace {

using namespace silhouette;
using SmallInts = std::int8_t __attribute__((vector_size(lanes)));

/// Upper bound of a unit normal's length after rounding.
constexpr float longestNormal = 1.0f + 1e-5f;

} // namespace

LightFacings::LightFacings(const PlanePairShadow& shadow) : count_(shadow.caps.size()) {
    const std::size_t size = (count_ + lanes - 1) / lanes * lanes;
    for (auto* component : {&x_, &y_, &z_, &w_})
        component->resize(size, 0.0f);
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::vec4& plane = shadow.caps[i].plane;
        x_[i] = plane.x;
        y_[i] = plane.y;
        z_[i] = plane.z;
        w_[i] = plane.w;
    }
}

void LightFacings::find(const LightBall& ball, int mantissaBits,
                        std::vector<std::int8_t>& facings) const {
    facings.resize(x_.size());
    const glm::vec4& light = ball.center;
    const float share = static_cast<float>(dotRounding(mantissaBits));
    const Floats lightX = all(light.x), lightY = all(light.y), lightZ = all(light.z),
                 lightW = all(light.w);
    // The terms of other lights of the ball sum to at most this much more.
    const Floats margin = all((ball.radius * longestNormal + ball.reach) * (1.0f + 2.0f * share) +
                              dotUnderflow(mantissaBits));
    for (std::size_t i = 0; i < x_.size(); i += lanes) {
        const Floats x = load(x_, i) * lightX, y = load(y_, i) * lightY, z = load(z_, i) * lightZ,
                     w = load(w_, i) * lightW;
        const Floats side = x + y + z + w;
        const Floats terms = magnitude(x) + magnitude(y) + magnitude(z) + magnitude(w);
        // Comparisons give -1 for true, and false for NaN and infinity against infinity.
        const Floats bound = margin + all(share) * terms;
        const Ints facing = (-side > bound) - (side > bound);
        const SmallInts narrow = __builtin_convertvector(facing, SmallInts);
        std::memcpy(facings.data() + i, &narrow, sizeof(narrow));
    }
    facings.resize(count_);
}

} // namespace edgeshade
