#include "src/shadow/lights/light_ball.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Steps of the light that a ball covers ahead. Larger balls list more records, smaller ones must
/// be replaced more often; tests/bench/proposals.py measures the lists of larger ones.
constexpr float stepsAhead = 6.0f;

/// Frames after which a light counts as at rest.
constexpr int framesToRest = 2;

/// Share of the radius that is safe from rounding of a distance.
constexpr double safeShare = 1.0 - 1e-6;

double distanceOf(const glm::vec4& a, const glm::vec4& b) {
    return glm::length(glm::dvec4(a) - glm::dvec4(b));
}

} // namespace

bool LightBall::holds(const glm::vec4& light) const {
    return light == center ||
           (light.w == center.w && distanceOf(light, center) <= safeShare * radius);
}

bool LightTrack::follow(const glm::vec4& light) {
    const float step = started_ ? static_cast<float>(distanceOf(light, last_)) : 0.0f;
    // A light that jumps, or has just started, is not yet in motion.
    const float pace = std::isfinite(step) ? std::min(step, lastStep_) : 0.0f;
    framesAtRest_ = step == 0.0f ? framesAtRest_ + 1 : 0;
    lastStep_ = step;
    last_ = light;
    const bool rests = ball_.radius > 0.0f && framesAtRest_ >= framesToRest;
    if (started_ && ball_.holds(light) && !rests) return false;
    started_ = true;
    ball_ = {light, rests ? 0.0f : stepsAhead * pace};
    return true;
}

bool LightTrack::take(const LightBall& ball) {
    if (started_ && ball_ == ball) return false;
    *this = LightTrack();
    started_ = true;
    ball_ = ball;
    return true;
}

} // namespace edgeshade
