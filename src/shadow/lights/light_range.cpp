#include "src/shadow/lights/light_range.hpp"

namespace edgeshade {

bool isBeyond(const Box& box, const glm::dvec3& light, double range) {
    const glm::dvec3 away = glm::max(glm::max(box.low - light, light - box.high), glm::dvec3(0.0));
    return glm::length(away) > rangeWidening * range;
}

bool areBeyond(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& light, double range) {
    Box box;
    for (const glm::dvec3& corner : corners)
        box.add(corner);
    return isBeyond(box, light, range);
}

} // namespace edgeshade
