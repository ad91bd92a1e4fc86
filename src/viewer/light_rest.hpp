#pragma once

#include "src/shadow/lights/light.hpp"

#include <utility>
#include <vector>

namespace edgeshade::viewer {

/// Since when lights are where they are, as large as they are and of the range that they have.
class LightRest {
  public:
    /// How long a light stays before it counts as resting, in seconds.
    static constexpr double enough = 0.5;

    /// Where they are at a time, in seconds on a clock that only goes forward.
    void see(const std::vector<Light>& lights, double now);
    bool rests(const Light& light, double now) const;
    /// Another scene: what rested has to rest anew.
    void clear() { since_.clear(); }

  private:
    struct Known {
        Light light;
        double since;
    };

    std::vector<Known> since_;
};

} // namespace edgeshade::viewer
