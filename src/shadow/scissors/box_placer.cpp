#include "src/shadow/scissors/box_placer.hpp"

#include "src/shadow/geometry/box_plane.hpp"

#include <cmath>

namespace edgeshade {

BoxPlacer::BoxPlacer(const glm::dmat4& worldFromBatch, const LightSpace& space)
    : turn_(space.turn() * glm::dmat3(worldFromBatch)),
      sizes_(glm::abs(turn_[0]), glm::abs(turn_[1]), glm::abs(turn_[2])),
      origin_(space.of(glm::dvec3(worldFromBatch[3]))),
      farthest_(glm::length(origin_) + glm::length(glm::dvec3(worldFromBatch[3]))) {}

LightBox BoxPlacer::placed(const Box& box) const {
    const glm::dvec3 middle = turn_ * box.center() + origin_;
    const double farthest =
        glm::length(sizes_ * glm::max(glm::abs(box.low), glm::abs(box.high))) + farthest_;
    const glm::dvec3 reach = sizes_ * (0.5 * (box.high - box.low)) + placingError * farthest;
    const LightBox placed{glm::vec3(middle - reach), glm::vec3(middle + reach)};
    for (glm::length_t i = 0; i < 3; ++i)
        if (!std::isfinite(placed.low[i]) || !std::isfinite(placed.high[i]))
            return LightBox::everything();
    return placed;
}

} // namespace edgeshade
