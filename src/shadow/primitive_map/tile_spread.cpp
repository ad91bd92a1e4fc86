#include "src/shadow/primitive_map/tile_spread.hpp"

#include "src/shadow/primitive_map/light_tiles.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Enlarges an extent against rounding.
constexpr double rounded = 1.0 + 1e-4;

} // namespace

TileSpread::TileSpread(const LightTiles& tiles, std::size_t tile) {
    if (!tiles.shape) return;
    const LightShape& shape = *tiles.shape;
    const glm::dmat3& axes = tiles.tiles[tile];
    any_ = true;
    directional_ = tiles.directional;
    for (glm::length_t i = 0; i < 2; ++i) {
        if (directional_) {
            low_[i] = high_[i] = rounded * shape.support(axes[i]) / std::abs(shape.center.z);
        } else {
            low_[i] = rounded * shape.support(axes[i] + axes[2]);
            high_[i] = rounded * shape.support(axes[i] - axes[2]);
        }
    }
    depth_ = directional_ ? 0.0 : rounded * shape.support(axes[2]);
    farthest_ = tiles.farthestReceiver;
}

RaySquare TileSpread::grown(const RaySquare& square, double nearest) const {
    if (!any_) return square;
    const double scale = directional_ ? std::max(farthest_ - nearest, 0.0) : 1.0 / nearest;
    // A support is convex, so along an axis it never exceeds the interpolation between its ends.
    const auto at = [&](const glm::dvec2& place) {
        return scale * glm::mix(low_, high_, 0.5 * (glm::clamp(place, -1.0, 1.0) + 1.0));
    };
    return {square.low - at(square.low), square.high + at(square.high)};
}

RaySquare TileSpread::reaching(const RaySquare& rays, double nearest) const {
    if (!any_ || !(nearest > nearestTold())) return rays;
    const double scale = directional_ ? std::max(farthest_ - nearest, 0.0) : 1.0 / nearest;
    const glm::dvec2 most = scale * glm::max(low_, high_);
    return {rays.low - most, rays.high + most};
}

double TileSpread::nearestTold() const {
    return directional_ ? -INFINITY : std::max(2.0 * depth_, 16.0 * mapRounding);
}

bool TileSpread::mayGoOn(const Interval& depths) const {
    if (!any_) return true;
    const double span = depths.high - depths.low;
    return directional_ ? span <= farthest_ - depths.high : span <= depths.low - 2.0 * depth_;
}

} // namespace edgeshade
