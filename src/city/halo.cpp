#include "src/city/halo.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace edgeshade::city {
namespace {

constexpr int mostBlades = 180;
/// Rooms for roundings: the share of a slope, radians of an azimuth, and metres.
constexpr double ofSlope = 1e-9, ofAngle = 1e-6, ofDistance = 1e-3;

/// The azimuths of some directions, and their least slope.
struct Bundle {
    double first = HUGE_VAL, last = -HUGE_VAL; ///< radians from east, anticlockwise
    double slope = HUGE_VAL;
};

/// The distance at which a ray from the origin enters a rectangle, 0 within it; infinite: it
/// doesn't.
double entryInto(const glm::dvec2& low, const glm::dvec2& high, const glm::dvec2& direction) {
    double enters = 0.0, leaves = HUGE_VAL;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        if (direction[axis] == 0.0) {
            if (low[axis] > 0.0 || high[axis] < 0.0) return HUGE_VAL;
            continue;
        }
        const double a = low[axis] / direction[axis], b = high[axis] / direction[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return enters <= leaves ? enters : HUGE_VAL;
}

} // namespace

SunFan::SunFan(std::span<const hours::Position> positions) {
    std::map<int, Bundle> bundles;
    for (const hours::Position& position : positions) {
        const double east = position.direction.x, north = -position.direction.z;
        const double angle = std::atan2(north, east);
        Bundle& bundle =
            bundles[static_cast<int>(std::floor(angle / (2.0 * std::numbers::pi) * mostBlades))];
        bundle.first = std::min(bundle.first, angle);
        bundle.last = std::max(bundle.last, angle);
        bundle.slope = std::min(bundle.slope,
                                position.direction.y / std::max(std::hypot(east, north), 1e-300));
    }
    for (const auto& [number, bundle] : bundles) {
        const double middle = 0.5 * (bundle.first + bundle.last);
        blades_.push_back({{std::cos(middle), std::sin(middle)},
                           0.5 * (bundle.last - bundle.first) + ofAngle,
                           bundle.slope * (1.0 - ofSlope)});
    }
    if (!blades_.empty()) leastSlope_ = std::ranges::min(blades_, {}, &Blade::slope).slope;
}

/// Offsets from points of a target to points of a caster, over the ground.
struct SunFan::Offsets {
    glm::dvec2 low, high;
    double farthest; ///< metres

    Offsets(const Box& caster, const TargetBox& target)
        : low(caster.low.x - target.east, caster.low.y - target.north),
          high(caster.high.x - target.west, caster.high.y - target.south),
          farthest(std::hypot(std::max(std::abs(low.x), std::abs(high.x)),
                              std::max(std::abs(low.y), std::abs(high.y)))) {}

    double nearest() const {
        return std::hypot(std::max({0.0, low.x, -high.x}), std::max({0.0, low.y, -high.y}));
    }

    /// The least rise of a ray towards the sun before it meets the caster's offsets.
    double riseAlong(const Blade& blade) const {
        const double margin = farthest * blade.halfAngle + ofDistance;
        const double enters = entryInto(low - margin, high + margin, blade.middle);
        return enters * blade.slope;
    }
};

bool SunFan::mayShade(const Box& caster, const TargetBox& target) const {
    const double rise = caster.high.z - target.lowest;
    if (rise < 0.0) return false;
    if (target.isUnder(caster)) return true;
    const Offsets offsets(caster, target);
    if (offsets.nearest() * leastSlope_ > rise) return false;
    return std::ranges::any_of(
        blades_, [&](const Blade& blade) { return offsets.riseAlong(blade) <= rise; });
}

double SunFan::leastHeight(const Box& caster, const TargetBox& target) const {
    if (target.isUnder(caster)) return target.lowest;
    const Offsets offsets(caster, target);
    double rise = HUGE_VAL;
    for (const Blade& blade : blades_)
        rise = std::min(rise, offsets.riseAlong(blade));
    return target.lowest + rise;
}

} // namespace edgeshade::city
