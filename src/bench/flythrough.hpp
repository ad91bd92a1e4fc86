#pragma once

#include "src/shadow/geometry/camera.hpp"
#include "src/shadow/geometry/light.hpp"

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

/// The lights after `share` of a flight during which each draws a small circle that starts where
/// it stands: a point light of 2 % of the scene's diagonal, a directional light of 3 degrees.
std::vector<Light> movedLights(const std::vector<Light>& lights, const Box& bounds, double share);

} // namespace edgeshade::bench
