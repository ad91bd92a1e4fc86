#pragma once

#include "preprocess/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace edgeshade::lab {

/// Random numbers that are the same on every platform, unlike the standard library's distributions.
class Draw {
  public:
    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::size_t below(std::size_t end) {
        return std::min(end - 1, static_cast<std::size_t>(unit() * static_cast<double>(end)));
    }
    /// A direction with a height (y) in the given range.
    glm::dvec3 direction(double lowest, double highest) {
        const double y = between(lowest, highest);
        const double angle = between(0.0, 6.283185307179586);
        const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
        return {r * std::cos(angle), y, r * std::sin(angle)};
    }

  private:
    std::mt19937 random_{20150};
};

/// A point on a surface and its normal.
struct SurfacePoint {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
};

/// The middle of a random triangle with an area; the origin if none is found.
SurfacePoint surfacePoint(const Scene& scene, Draw& draw);

} // namespace edgeshade::lab
