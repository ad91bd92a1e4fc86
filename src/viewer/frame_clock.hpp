#pragma once

#include "src/viewer/view_state.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Turns the time of day into the animation's.
class FrameClock {
  public:
    /// Moves the state's time on by what has passed since the last call, in a circle of `length`
    /// seconds; returns whether it moved. Time that passes while nothing plays doesn't count.
    bool advance(double now, double length, ViewState& state);

  private:
    std::optional<double> last_; ///< while something plays
};

/// The mean of the last few figures, so that they can be read.
class RecentMean {
  public:
    void add(double value);
    double mean() const;

  private:
    static constexpr std::size_t most = 30;
    std::vector<double> values_;
    std::size_t next_ = 0;
};

} // namespace edgeshade::viewer
