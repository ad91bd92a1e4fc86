#include "src/viewer/gestures.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

constexpr double closest = 1.0; // least distance of two fingers in pixels, so that nothing is
                                // divided by 0

} // namespace

void Gestures::down(const Pointer& pointer) {
    up(pointer);
    down_.push_back(pointer);
}

std::optional<Motion> Gestures::move(const Pointer& pointer) {
    const auto found = std::find_if(down_.begin(), down_.end(),
                                    [&](const Pointer& p) { return p.id == pointer.id; });
    if (found == down_.end()) return std::nullopt;
    const glm::dvec2 before = found->place();
    const glm::dvec2 after = pointer.place();
    found->x = pointer.x;
    found->y = pointer.y;
    if (down_.size() == 1) return Motion{false, before, after, 1.0};
    const auto finger = static_cast<std::size_t>(found - down_.begin());
    if (finger > 1) return std::nullopt;
    const glm::dvec2 other = down_[1 - finger].place();
    return Motion{true, 0.5 * (before + other), 0.5 * (after + other),
                  std::max(closest, glm::distance(after, other)) /
                      std::max(closest, glm::distance(before, other))};
}

void Gestures::up(const Pointer& pointer) {
    std::erase_if(down_, [&](const Pointer& p) { return p.id == pointer.id; });
}

} // namespace edgeshade::viewer
