#include "src/viewer/counting_pace.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

constexpr std::size_t mostAtOnce = 8;
constexpr double quick = 0.025, slow = 0.05; ///< seconds between frames

} // namespace

std::size_t CountingPace::next(double now) {
    if (last_ && now - *last_ < quick) atOnce_ = std::min(2 * atOnce_, mostAtOnce);
    if (last_ && now - *last_ > slow) atOnce_ = std::max<std::size_t>(atOnce_ / 2, 1);
    last_ = now;
    return atOnce_;
}

std::size_t nextPicture(std::size_t counted, std::size_t of) {
    std::size_t next = 4;
    while (next <= counted)
        next *= 4;
    return std::min(next, of);
}

} // namespace edgeshade::viewer
