#pragma once

#include "src/shadow/geometry/light.hpp"

#include <vector>

namespace edgeshade::viewer {

/// How far lights will be from where they are in the seconds to come, by how fast they moved.
class LightPace {
  public:
    /// Their speed is that of so long a time, in seconds.
    static constexpr double span = 0.5;
    /// For so long they are to stay within wanderOf(), in seconds, if they go on as they do.
    static constexpr double ahead = 4.0;

    /// Where they are at a time, in seconds on a clock that only goes forward. If their number is
    /// another one, nothing is known of them.
    void see(const std::vector<Light>& lights, double now);

    /// FrameLight::wander of one of them, by index: 0 where it rests, is too fast for casters to be
    /// culled (mostWander()), or isn't known long enough. `sceneSize`: its diagonal.
    double wanderOf(std::size_t light, double sceneSize) const;

  private:
    struct Known {
        Light light;
        double speed = -1.0; ///< radians or scene units a second; below 0: not known
    };

    std::vector<Known> known_; ///< where they were at `since_`
    double since_ = 0.0;
};

} // namespace edgeshade::viewer
