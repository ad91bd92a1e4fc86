#pragma once

#include "src/viewer/overlay_pass.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace edgeshade::viewer {

using OverlayColor = std::array<std::uint8_t, 4>; ///< sRGB, alpha

/// Collects the triangles of lines and discs, in pixels.
class OverlayDrawing {
  public:
    void triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                  const OverlayColor& color) {
        for (const glm::dvec2& corner : {a, b, c})
            triangles.push_back({glm::vec2(corner), {color[0], color[1], color[2], color[3]}});
    }

    void line(const glm::dvec2& from, const glm::dvec2& to, double width,
              const OverlayColor& color) {
        const glm::dvec2 way = to - from;
        if (glm::length(way) == 0.0) return;
        const glm::dvec2 across = 0.5 * width * glm::dvec2(-way.y, way.x) / glm::length(way);
        triangle(from - across, from + across, to + across, color);
        triangle(from - across, to + across, to - across, color);
    }

    void disc(const glm::dvec2& middle, double radius, const OverlayColor& color) {
        for (int i = 0; i < corners; ++i)
            triangle(middle, middle + radius * around(i), middle + radius * around(i + 1), color);
    }

    void circle(const glm::dvec2& middle, double radius, double width, const OverlayColor& color) {
        for (int i = 0; i < corners; ++i)
            line(middle + radius * around(i), middle + radius * around(i + 1), width, color);
    }

    static glm::dvec2 around(int corner) {
        const double angle = glm::two_pi<double>() * corner / corners;
        return {std::cos(angle), std::sin(angle)};
    }

    static constexpr int corners = 24;
    OverlayTriangles triangles;
};

} // namespace edgeshade::viewer
