#pragma once

#include "src/shadow/view/camera.hpp"

namespace edgeshade::viewer {

/// A ray from the eye; the direction has unit length.
struct Ray {
    glm::dvec3 from{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// A camera and its picture in pixels, y down: converts between pixels and points.
struct PictureView {
    Camera camera;
    double width = 1.0;
    double height = 1.0;

    double aspect() const { return width / height; }
    /// Size of a pixel in the world, at a depth along the viewing direction.
    double pixelAt(double depth) const;
    glm::dvec3 forward() const; ///< unit length
    double depthOf(const glm::dvec3& point) const;
    Ray rayThrough(const glm::dvec2& pixel) const;
    /// The point on the ray through a pixel, at a depth along the viewing direction.
    glm::dvec3 pointAt(const glm::dvec2& pixel, double depth) const;
    /// The pixel that shows a point; the point's depth must be above 0.
    glm::dvec2 pixelOf(const glm::dvec3& point) const;
};

/// The eye goes around `camera.to` at its distance: `yaw` to the right, `pitch` upwards, radians.
/// It stops short of the poles, so that the picture never turns upside down.
Camera orbited(const Camera& camera, double yaw, double pitch);

/// Moves eye and pivot sideways so that points at `depth` move by this many pixels.
Camera panned(const PictureView& view, const glm::dvec2& pixels, double depth);

/// Moves eye and pivot towards `target` (factor < 1) or away, keeping the viewing direction and the
/// target's place in the picture. Later orbiting turns around the zoom's target, since the pivot
/// moves there too. Nothing changes if the pivot's distance would leave [nearest, farthest].
Camera zoomed(const Camera& camera, const glm::dvec3& target, double factor, double nearest,
              double farthest);

} // namespace edgeshade::viewer
