#include "src/shadow/lights/light_view.hpp"

#include "src/shadow/geometry/vectors.hpp"

namespace edgeshade {

LightView::LightView(const Light& light)
    : directional(light.position.w == 0.0), position(light.position),
      range(light.hasRange() ? light.range : std::numeric_limits<double>::infinity()),
      faces{glm::dmat3(1.0)} {
    if (!directional) {
        const auto six = directionFaces();
        faces.assign(six.begin(), six.end());
        return;
    }
    const auto axes = axesAlong(unitOf(position));
    across = axes[0];
    upward = -axes[1];
}

} // namespace edgeshade
