#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Planes with each component in an array of its own, so that the compiler tests several at once.
class PlaneColumns {
  public:
    void add(const glm::vec4& plane) {
        x_.push_back(plane.x);
        y_.push_back(plane.y);
        z_.push_back(plane.z);
        w_.push_back(plane.w);
    }
    std::size_t size() const { return x_.size(); }

    /// Calls use(i) with the index of each of the first `end` planes for which |dot(plane, point)|,
    /// evaluated in floats from x to w, is at most `distance`. Ascending.
    template <class Use>
    void forNear(const glm::vec4& point, float distance, std::size_t end, Use use) const {
        constexpr std::size_t block = 64; // planes tested at once; few are near
        const auto isNear = [&](std::size_t i) {
            const float height =
                x_[i] * point.x + y_[i] * point.y + z_[i] * point.z + w_[i] * point.w;
            return std::abs(height) <= distance;
        };
        for (std::size_t first = 0; first < end; first += block) {
            const std::size_t last = std::min(first + block, end);
            int any = 0; // without a branch
            for (std::size_t i = first; i < last; ++i)
                any |= isNear(i) ? 1 : 0;
            if (any == 0) continue;
            for (std::size_t i = first; i < last; ++i)
                if (isNear(i)) use(i);
        }
    }

  private:
    std::vector<float> x_, y_, z_, w_;
};

} // namespace edgeshade
