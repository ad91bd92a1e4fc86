#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/camera.hpp"

#include <vector>

namespace edgeshade::bench {

/// A closed flight around a scene and through it: from where the whole of it is seen, in a circle
/// that narrows and sinks until the eye is well inside the scene's sphere, and out again. The same
/// for the same scene, field of view and picture.
class Flythrough {
  public:
    /// `bounds`: the scene's; `aspect`: width over height.
    Flythrough(const Box& bounds, double fovDegrees, double aspect);

    /// Where the eye is after `share` of the way; 0 and 1 are the same.
    Camera cameraAt(double share) const;

  private:
    glm::dvec3 center_;
    double framing_; ///< distance from which all is seen
    double fovDegrees_;
};

/// How far from its circle's middle a light is that moves during a flight: a directional light
/// so many degrees, a point light 150ths of the scene's diagonal.
inline constexpr double usualCircle = 3.0;

/// The lights after `share` of a flight during which each draws a circle that starts where it
/// stands.
std::vector<Light> movedLights(const std::vector<Light>& lights, const Box& bounds, double circle,
                               double share);

} // namespace edgeshade::bench
