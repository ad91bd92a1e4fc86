#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/primitive_map/ray_square.hpp"

namespace edgeshade {

struct LightTiles;

/// How far segments from a square's points to any point of a light stray from the square's own
/// rays, which go to the light's middle (docs/method.md, C42). Zero for a light without an extent.
class TileSpread {
  public:
    TileSpread() = default;
    TileSpread(const LightTiles& tiles, std::size_t tile);

    bool any() const { return any_; }
    /// The rays of all points that such segments reach at depths of at least `nearest`, which must
    /// be above nearestTold().
    RaySquare grown(const RaySquare& square, double nearest) const;
    /// The rays from which segments may meet a point of `rays` at depths of at least `nearest`.
    RaySquare reaching(const RaySquare& rays, double nearest) const;
    /// Depth up to which any ray's segments may meet an occluder, as it is so close to the light's
    /// middle.
    double nearestTold() const;
    /// Whether segments that end in a group of these depths, and are continued to its farther end,
    /// stay within grown().
    bool mayGoOn(const Interval& depths) const;
    /// The extent along x and y, of the rays |x| <= w and |y| <= w, times their depth.
    const glm::dvec2& low() const { return low_; }   ///< of rays at -w
    const glm::dvec2& high() const { return high_; } ///< of rays at w

  private:
    bool any_ = false, directional_ = true;
    glm::dvec2 low_{0.0}, high_{0.0};
    double depth_ = 0.0;    ///< the extent along w
    double farthest_ = 0.0; ///< for a directional light, depth of its farthest receiver
};

} // namespace edgeshade
