#pragma once

#include "src/rays/surface_triangle.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace edgeshade::rays {

/// Whether light passes through an alpha-tested caster at barycentric coordinates (u, v) of its
/// second and third corner.
using IsHole = std::function<bool(const SurfaceTriangle&, double u, double v)>;

/// Holes of casters.
class Holes {
  public:
    /// `isHole`: null: there are none.
    Holes(const Scene& scene, const std::vector<SurfaceTriangle>& triangles, IsHole isHole);

    /// Whether any triangle may have some.
    bool any() const { return static_cast<bool>(isHole_); }

    /// Whether light passes through where the line from `origin` meets a triangle. Those after
    /// `triangles` have no holes.
    bool at(const std::vector<SurfaceTriangle>& triangles, std::uint32_t triangle,
            const glm::dvec3& origin, const glm::dvec3& direction) const {
        return triangle < mayHave_.size() && mayHave_[triangle] != 0 &&
               isMet(triangles[triangle], origin, direction);
    }

  private:
    bool isMet(const SurfaceTriangle& triangle, const glm::dvec3& origin,
               const glm::dvec3& direction) const;

    IsHole isHole_;
    std::vector<std::uint8_t> mayHave_; ///< by triangle; empty: none has; so are those after them
};

} // namespace edgeshade::rays
