#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/camera.hpp"

#include <vector>

namespace edgeshade::bench {

/// A closed flight around and through a scene. It starts where the whole scene is in view, follows
/// a circle that narrows and sinks until the eye is well inside the scene's sphere, and goes out
/// again. Deterministic for a scene, field of view and picture.
class Flythrough {
  public:
    /// `bounds`: the scene's; `aspect`: width over height.
    Flythrough(const Box& bounds, double fovDegrees, double aspect);

    /// The camera after `share` of the way; 0 and 1 are the same.
    Camera cameraAt(double share) const;

  private:
    glm::dvec3 center_;
    double framing_; ///< distance from which the whole scene is in view
    double fovDegrees_;
};

/// Radius of the circle of a moving light: for a directional light in degrees, for a point light in
/// 150ths of the scene's diagonal.
inline constexpr double usualCircle = 3.0;

/// The lights after `share` of a flight, in which each moves on a circle that starts at its own
/// place.
std::vector<Light> movedLights(const std::vector<Light>& lights, const Box& bounds, double circle,
                               double share);

} // namespace edgeshade::bench
