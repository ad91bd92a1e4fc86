#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Lights whose homogeneous coordinates (docs/method.md, Terms) are within `radius` of `center`, in
/// an object's space. For point lights it is a ball; for directional lights, w = 0, a cone of
/// directions.
struct LightBall {
    glm::vec4 center{0.0f};
    float radius = 0.0f;
    float reach = 0.0f; ///< the shaders treat lights this near to a plane as in it:
                        ///< ContactCaps::reach

    bool holds(const glm::vec4& light) const;
    bool operator==(const LightBall&) const = default;
};

/// Chooses balls around a light as it moves. Results for a ball then serve several frames of a
/// moving light, and the ball is no larger than needed for a light at rest.
class LightTrack {
  public:
    /// Takes the light of the next frame. Returns whether the ball has changed.
    bool follow(const glm::vec4& light);

    /// Takes a known ball instead of choosing one. Returns whether the ball has changed.
    bool take(const LightBall& ball);

    const LightBall& ball() const { return ball_; }

  private:
    LightBall ball_;
    glm::vec4 last_{0.0f};
    float lastStep_ = 0.0f;
    int framesAtRest_ = 0;
    bool started_ = false;
};

} // namespace edgeshade
