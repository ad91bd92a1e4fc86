#include "src/city/halo.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::city {
namespace {

/// Room for the roundings of a slope, a distance and their product.
constexpr double roundings = 1e-9;

} // namespace

double TargetBox::distanceTo(const Box& box) const {
    return std::hypot(std::max({0.0, box.low.x - east, west - box.high.x}),
                      std::max({0.0, box.low.y - north, south - box.high.y}));
}

double leastSlopeOf(std::span<const hours::Position> positions) {
    if (positions.empty()) return 1.0;
    double least = HUGE_VAL;
    for (const hours::Position& position : positions) {
        const glm::dvec3& sun = position.direction;
        least = std::min(least, sun.y / std::max(std::hypot(sun.x, sun.z), 1e-300));
    }
    return least * (1.0 - roundings);
}

bool mayShade(const Box& caster, const TargetBox& target, double slope) {
    const double rise = caster.high.z - target.lowest;
    return rise >= 0.0 && target.distanceTo(caster) * slope <= rise;
}

} // namespace edgeshade::city
