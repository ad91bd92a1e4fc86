#pragma once

#include <cstddef>
#include <optional>

namespace edgeshade::viewer {

/// Chooses how many masks to count between two frames: as many as keep frames quick.
class CountingPace {
  public:
    /// `now`: the time of this frame in seconds.
    std::size_t next(double now);

    /// Ignores the time until the next frame.
    void restart() { last_.reset(); }

  private:
    std::size_t atOnce_ = 1;
    std::optional<double> last_;
};

/// The next number of counted masks at which a picture is worth drawing: 4, 16, 64 and so on, and
/// all. `of`: all; `counted`: so far.
std::size_t nextPicture(std::size_t counted, std::size_t of);

} // namespace edgeshade::viewer
