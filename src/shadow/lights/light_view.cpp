#include "src/shadow/lights/light_view.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <array>

namespace edgeshade {

namespace {

std::span<const glm::dmat3> facesOf(bool directional) {
    static const std::array<glm::dmat3, 1> one{glm::dmat3(1.0)};
    static const std::array<glm::dmat3, 6> six = directionFaces();
    if (directional) return one;
    return six;
}

} // namespace

LightView::LightView(const Light& light)
    : directional(light.position.w == 0.0), position(light.position),
      range(light.hasRange() ? light.range : std::numeric_limits<double>::infinity()),
      faces(facesOf(directional)) {
    if (!directional) return;
    const auto axes = axesAlong(unitOf(position));
    across = axes[0];
    upward = -axes[1];
}

} // namespace edgeshade
