#include "src/shadow/geometry/light_view.hpp"

namespace edgeshade {

LightView::LightView(const Light& light)
    : directional(light.position.w == 0.0), position(light.position), faces{glm::dmat3(1.0)} {
    if (!directional) {
        const auto six = directionFaces();
        faces.assign(six.begin(), six.end());
        return;
    }
    const glm::dvec3 towards = glm::normalize(position);
    const glm::dvec3 other = std::abs(towards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    across = glm::normalize(glm::cross(towards, other));
    upward = glm::cross(towards, across);
}

} // namespace edgeshade
