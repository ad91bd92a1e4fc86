#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/primitive_map/ray_square.hpp"

namespace edgeshade {

struct LightTiles;

/// How far segments from a square's points to any of a light's places stray from the square's own
/// rays, which go to the light's middle (docs/method.md, C42). Of a light without an extent, not at
/// all.
class TileSpread {
  public:
    TileSpread() = default;
    TileSpread(const LightTiles& tiles, std::size_t tile);

    bool any() const { return any_; }
    /// The rays of all that such segments meet no nearer than `nearest`, which is above
    /// nearestTold().
    RaySquare grown(const RaySquare& square, double nearest) const;
    /// The rays from which segments may meet something of these rays, no nearer than that.
    RaySquare reaching(const RaySquare& rays, double nearest) const;
    /// What nears the light's middle as much is met by segments of any ray.
    double nearestTold() const;
    /// Whether segments that end in a group of such depths, and go on to its farther end, stay in
    /// what grown() says.
    bool mayGoOn(const Interval& depths) const;
    /// The extent along x and y, of the rays |x| <= w and |y| <= w, times their depth.
    const glm::dvec2& low() const { return low_; }   ///< of those at -w
    const glm::dvec2& high() const { return high_; } ///< of those at w

  private:
    bool any_ = false, directional_ = true;
    glm::dvec2 low_{0.0}, high_{0.0};
    double depth_ = 0.0;    ///< the extent along w
    double farthest_ = 0.0; ///< depth of what it shines on, of a directional light
};

} // namespace edgeshade
