#pragma once

#include "src/shadow/lights/light.hpp"

#include <utility>
#include <vector>

namespace edgeshade::viewer {

/// Remembers since when each light has kept its position, extent and range.
class LightRest {
  public:
    /// Seconds that a light must stay the same before it counts as resting.
    static constexpr double enough = 0.5;

    /// Notes the lights at a time, in seconds on a clock that only goes forward.
    void see(const std::vector<Light>& lights, double now);
    bool rests(const Light& light, double now) const;
    /// For a new scene: all lights must come to rest again.
    void clear() { since_.clear(); }

  private:
    struct Known {
        Light light;
        double since;
    };

    std::vector<Known> since_;
};

} // namespace edgeshade::viewer
