#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace edgeshade {

/// An axis-aligned box; empty until something is added.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return low.x > high.x; }
    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    bool holds(const glm::dvec3& point) const {
        return glm::all(glm::lessThanEqual(low, point)) &&
               glm::all(glm::lessThanEqual(point, high));
    }
    /// Corner 0 to 7: bit 0 for high x, bit 1 for high y, bit 2 for high z.
    glm::dvec3 corner(int i) const {
        return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    }
    /// Distance from the point to the box, a lower bound of its distance to anything inside; 0 for
    /// an empty box.
    double distanceTo(const glm::dvec3& point) const {
        return empty()
                   ? 0.0
                   : glm::length(glm::max(glm::max(low - point, point - high), glm::dvec3(0.0)));
    }
    glm::dvec3 center() const { return empty() ? glm::dvec3(0.0) : 0.5 * (low + high); }
    double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
};

} // namespace edgeshade
