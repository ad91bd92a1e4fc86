#include "src/render/accumulation/subpixels.hpp"

#include "src/shadow/geometry/quasirandom.hpp"

namespace edgeshade {

glm::dvec2 subpixelOffset(std::uint64_t n) {
    const std::array<double, 2> place = evenly<2>(n);
    return {place[0] - 0.5, place[1] - 0.5};
}

Frustum sampledAt(Frustum frustum, const glm::dvec2& offset, int width, int height) {
    const glm::dvec2 shift = offset * frustum.size() / glm::dvec2(width, height);
    frustum.low += shift;
    frustum.high += shift;
    return frustum;
}

} // namespace edgeshade
