#pragma once

#include "src/viewer/view_state.hpp"

#include <optional>

namespace edgeshade::viewer {

inline constexpr double dayHoursASecond = 1.0; ///< of a day that plays

/// Plays the day of a sun by place and time, round and round.
class DayClock {
  public:
    /// The sun after what has passed since the last call, to the second; nothing where it stays.
    /// Time that passes while nothing plays doesn't count.
    std::optional<SunState> advance(double now, const ViewState& state);

  private:
    std::optional<double> last_; ///< while it plays
    double rest_ = 0.0;          ///< of a second of the day
};

} // namespace edgeshade::viewer
