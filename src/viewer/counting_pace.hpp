#pragma once

#include <cstddef>
#include <optional>

namespace edgeshade::viewer {

/// How many masks are counted between two frames: as many as leave frames quick.
class CountingPace {
  public:
    /// `now`: seconds, of this frame.
    std::size_t next(double now);

    /// Nothing is known of the frame before the next one.
    void restart() { last_.reset(); }

  private:
    std::size_t atOnce_ = 1;
    std::optional<double> last_;
};

/// How many, of so many to be counted, make the next picture worth drawing: 4, 16, 64 and so on,
/// and all.
std::size_t nextPicture(std::size_t counted, std::size_t of);

} // namespace edgeshade::viewer
