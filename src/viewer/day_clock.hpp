#pragma once

#include "src/viewer/view_state.hpp"

#include <optional>

namespace edgeshade::viewer {

inline constexpr double dayHoursASecond = 1.0; ///< speed at which a day plays

/// Plays the day of a sun by place and time, repeatedly.
class DayClock {
  public:
    /// The sun after the time since the last call, to the second; nothing if it hasn't moved. Time
    /// during which nothing plays doesn't count.
    std::optional<SunState> advance(double now, const ViewState& state);

  private:
    std::optional<double> last_; ///< of the last call; empty unless the day plays
    double rest_ = 0.0;          ///< fraction of a second of the day that is carried over
};

} // namespace edgeshade::viewer
