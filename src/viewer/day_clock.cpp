#include "src/viewer/day_clock.hpp"

#include <cmath>

namespace edgeshade::viewer {

std::optional<SunState> DayClock::advance(double now, const ViewState& state) {
    if (!state.dayPlays || !state.sun) {
        last_.reset();
        return std::nullopt;
    }
    const double passed = last_ ? now - *last_ : 0.0;
    if (last_ && passed <= 0.0) return std::nullopt;
    last_ = now;
    const double due = rest_ + passed * dayHoursASecond * 3600.0;
    const double whole = std::floor(due);
    rest_ = due - whole;
    if (whole == 0.0) return std::nullopt;
    return movedWithinDay(*state.sun,
                          std::chrono::seconds(std::llround(std::fmod(whole, 86400.0))));
}

} // namespace edgeshade::viewer
