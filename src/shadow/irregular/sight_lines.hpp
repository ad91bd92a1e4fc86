#pragma once

#include "src/shadow/irregular/light_space.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <array>

namespace edgeshade {

/// A plane in a LightSpace: dot(normal, p) + offset is 0 on it.
struct SpacePlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;

    static SpacePlane through(const std::array<glm::dvec3, 3>& corners);
    double heightOf(const glm::dvec3& place) const { return glm::dot(normal, place) + offset; }
};

/// The lines of sight of a picture's pixels in a light's space.
class SightLines {
  public:
    SightLines(const FrameView& view, const LightSpace& space);

    /// The intersection of a pixel's line of sight with a triangle of the plane. The result is
    /// within the triangle, even though the rasteriser, whose vertices are on a grid, may have
    /// drawn a pixel whose line misses it.
    glm::dvec3 placeOn(const std::array<glm::dvec3, 3>& corners, const SpacePlane& plane, int x,
                       int y) const;
    /// The sign of heights over a plane on the eye's side; 0: the plane is edge-on.
    int eyeSideOf(const SpacePlane& plane) const;

  private:
    bool perspective_;
    glm::dvec3 eye_, forward_;
    /// Points across the line of sight: the first pixel's, and steps to the next column and row.
    glm::dvec3 first_, column_, row_;
};

} // namespace edgeshade
