#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Lights whose homogeneous coordinates (docs/method.md, Terms) are no farther from `center` than
/// `radius`, in an object's space. For point lights a ball; for directional lights, w = 0, a cone
/// of directions.
struct LightBall {
    glm::vec4 center{0.0f};
    float radius = 0.0f;
    float reach = 0.0f; ///< the shaders take lights so near a plane to be in it: ContactCaps'

    bool holds(const glm::vec4& light) const;
    bool operator==(const LightBall&) const = default;
};

/// Chooses balls around a light as it moves, so that what was worked out for a ball serves for
/// several frames of a light in motion, and is no larger than needed for a light at rest.
class LightTrack {
  public:
    /// The light of one more frame. True if the ball is another one now.
    bool follow(const glm::vec4& light);

    /// A ball that is known, in place of one that is chosen. True if it is another one now.
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
