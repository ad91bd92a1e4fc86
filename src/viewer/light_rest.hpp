#pragma once

#include "src/shadow/geometry/light.hpp"

#include <utility>
#include <vector>

namespace edgeshade::viewer {

/// Since when lights are where they are.
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
    std::vector<std::pair<glm::dvec4, double>> since_; ///< by position
};

} // namespace edgeshade::viewer
