#pragma once

#include "src/viewer/input.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade::viewer {

/// What one movement of a pointer amounts to.
struct Motion {
    bool pinch = false; ///< two fingers: their middle moved, and their distance changed
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    double spread = 1.0; ///< new distance of two fingers over the old one
};

/// Tells one pointer's dragging from two fingers' pinching; what either does is not its business.
class Gestures {
  public:
    void down(const Pointer& pointer);
    /// Nothing for a pointer that isn't down, and for further fingers than two.
    std::optional<Motion> move(const Pointer& pointer);
    void up(const Pointer& pointer);

    std::size_t count() const { return down_.size(); }

  private:
    std::vector<Pointer> down_; ///< in the order in which they came
};

} // namespace edgeshade::viewer
