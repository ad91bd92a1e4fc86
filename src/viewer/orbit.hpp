#pragma once

#include "src/shadow/view/camera.hpp"

namespace edgeshade::viewer {

/// A ray from the eye; the direction has unit length.
struct Ray {
    glm::dvec3 from{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// A camera and the picture that it makes, in pixels, rows down: what lies between the two.
struct PictureView {
    Camera camera;
    double width = 1.0;
    double height = 1.0;

    double aspect() const { return width / height; }
    /// What a pixel measures in the world at a depth along the viewing direction.
    double pixelAt(double depth) const;
    glm::dvec3 forward() const; ///< unit length
    double depthOf(const glm::dvec3& point) const;
    Ray rayThrough(const glm::dvec2& pixel) const;
    /// Where the ray through a pixel is at a depth along the viewing direction.
    glm::dvec3 pointAt(const glm::dvec2& pixel, double depth) const;
    /// Where a point is seen; its depth must be above 0.
    glm::dvec2 pixelOf(const glm::dvec3& point) const;
};

/// The eye goes around `camera.to` at its distance: `yaw` to the right, `pitch` upwards, radians.
/// It stops short of the poles, so the picture never turns over.
Camera orbited(const Camera& camera, double yaw, double pitch);

/// Eye and pivot move sideways such that what lies at `depth` moves by so many pixels.
Camera panned(const PictureView& view, const glm::dvec2& pixels, double depth);

/// Eye and pivot come nearer to `target` (factor < 1) or go away, which leaves the viewing
/// direction and the target's place in the picture. Orbiting goes on around what was zoomed to,
/// since the pivot goes there too. Nothing changes where the pivot's distance would leave
/// [nearest, farthest].
Camera zoomed(const Camera& camera, const glm::dvec3& target, double factor, double nearest,
              double farthest);

} // namespace edgeshade::viewer
