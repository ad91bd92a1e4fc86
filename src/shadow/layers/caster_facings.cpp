#include "src/shadow/layers/caster_facings.hpp"

#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace edgeshade {
namespace {

/// Bound of the error of planes that are only rounded to floats: of the unit normal, and of the
/// offset as a share of the coordinates.
constexpr double tight = 4.0 * 0x1p-24;

/// The largest distance of a point from the origin, of coordinates up to 1.
constexpr double mostDistance = 1.7320508075688772 + 1e-6;

/// Rounding of a normal in doubles, relative to the sine of the triangle's angle.
constexpr double normalRounding = 0x1p-49;

PlaneError errorOf(const CapRecord& cap) {
    const glm::dvec3 a(cap.a), ab = glm::dvec3(cap.b) - a, ac = glm::dvec3(cap.c) - a;
    const glm::dvec3 across = glm::cross(ab, ac);
    const double length = glm::length(across);
    const glm::dvec3 normal(cap.plane);
    const double slope = glm::length(normal - across / length) +
                         normalRounding * glm::length(ab) * glm::length(ac) / length;
    return {std::isfinite(slope) ? slope : INFINITY,
            std::abs(glm::dot(normal, a) + static_cast<double>(cap.plane.w))};
}

using PlaneKey = std::array<float, 4>;

/// The same for a plane and the opposite one.
PlaneKey keyOf(const glm::vec4& plane) {
    float sign = 1.0f;
    for (glm::length_t i = 3; i >= 0; --i)
        if (plane[i] != 0.0f) sign = plane[i] < 0.0f ? -1.0f : 1.0f;
    const glm::vec4 key = sign * plane + 0.0f; // no -0
    return {key.x, key.y, key.z, key.w};
}

/// The planes of loose triangles, each with its largest errors. `size`: of the coordinates.
std::map<PlaneKey, PlaneError> loosePlanes(const PlanePairShadow& shadow, double size) {
    std::map<PlaneKey, PlaneError> planes;
    for (const CapRecord& cap : shadow.caps) {
        if (!cap.casts()) continue;
        const PlaneError error = errorOf(cap);
        if (error.slope <= tight && error.offset <= tight * size) continue;
        PlaneError& largest = planes[keyOf(cap.plane)];
        largest = {std::max(largest.slope, error.slope), std::max(largest.offset, error.offset)};
    }
    return planes;
}

} // namespace

CasterFacings::CasterFacings(const PlanePairShadow& shadow) : shadow_(&shadow), facings_(shadow) {
    for (const ShadowCluster& cluster : shadow.clusters)
        for (const glm::dvec3& corner : {cluster.bounds.low, cluster.bounds.high})
            size_ = std::max(size_, largestComponent(corner));
    const std::map<PlaneKey, PlaneError> planes = loosePlanes(shadow, size_);
    if (planes.empty()) return;
    for (std::uint32_t cap = 0; cap < shadow.caps.size(); ++cap)
        if (const auto found = planes.find(keyOf(shadow.caps[cap].plane)); found != planes.end())
            loose_.push_back({cap, found->second});
}

void CasterFacings::follow(const LightInBatch& light, FollowedCasters& followed) const {
    // No triangle is farther from the light. An error of its normal counts times this.
    const double distance = light.length() + mostDistance * size_ * light.place.w;
    const auto reachFor = [&](const PlaneError& error) {
        const double reach =
            error.slope * distance + error.offset * light.place.w + light.floatRounding();
        return reach * (1.0 + 1e-6);
    };
    LightBall ball{glm::vec4(light.place)};
    ball.reach = static_cast<float>(reachFor({tight, tight * size_}));
    FollowedFacings& all = followed.facings;
    facings_.follow(ball, 23, all);
    followed.loosePlanes.resize(loose_.size());
    for (std::size_t i = 0; i < loose_.size(); ++i) {
        const auto& [cap, error] = loose_[i];
        const std::size_t run = cap / FollowedFacings::run;
        std::int8_t& facing = all.facings[cap];
        if (all.foundAt[run] == all.look) followed.loosePlanes[i] = facing;
        const double side = glm::dot(glm::dvec4(shadow_->caps[cap].plane), light.place);
        const std::int8_t certain =
            std::abs(side) > reachFor(error) ? followed.loosePlanes[i] : std::int8_t{0};
        if (facing != certain) all.changedAt[run] = all.look;
        facing = certain;
    }
}

} // namespace edgeshade
