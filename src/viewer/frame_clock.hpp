#pragma once

#include "src/viewer/view_state.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Advances the animation's time by the clock.
class FrameClock {
  public:
    /// Moves the state's time on by the time since the last call, modulo `length` seconds; returns
    /// whether it moved. Time during which nothing plays doesn't count.
    bool advance(double now, double length, ViewState& state);

  private:
    std::optional<double> last_; ///< of the last call; empty unless something plays
};

/// The mean of the last few values, steady enough to read.
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
