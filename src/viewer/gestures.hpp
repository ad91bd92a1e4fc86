#pragma once

#include "src/viewer/input.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade::viewer {

/// One movement of a pointer.
struct Motion {
    bool pinch = false; ///< two fingers moved their midpoint and changed their distance
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    double spread = 1.0; ///< new distance of two fingers over the old one
};

/// Distinguishes dragging by one pointer from pinching by two fingers, and leaves their effects to
/// the caller.
class Gestures {
  public:
    void down(const Pointer& pointer);
    /// Empty for a pointer that isn't down, and for fingers beyond the second.
    std::optional<Motion> move(const Pointer& pointer);
    void up(const Pointer& pointer);

    std::size_t count() const { return down_.size(); }

  private:
    std::vector<Pointer> down_; ///< in the order in which they came down
};

} // namespace edgeshade::viewer
