#include "src/viewer/frame_clock.hpp"

#include <cmath>
#include <numeric>

namespace edgeshade::viewer {

bool FrameClock::advance(double now, double length, ViewState& state) {
    if (!state.playing || length <= 0.0) {
        last_.reset();
        return false;
    }
    const double passed = last_ ? now - *last_ : 0.0;
    last_ = now;
    if (passed <= 0.0) return false;
    state.time = std::fmod(state.time + passed * state.speed, length);
    return true;
}

void RecentMean::add(double value) {
    if (values_.size() < most)
        values_.push_back(value);
    else
        values_[next_] = value;
    next_ = (next_ + 1) % most;
}

double RecentMean::mean() const {
    if (values_.empty()) return 0.0;
    return std::accumulate(values_.begin(), values_.end(), 0.0) /
           static_cast<double>(values_.size());
}

} // namespace edgeshade::viewer
