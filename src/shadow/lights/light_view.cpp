#include "src/shadow/lights/light_view.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade {

namespace {

std::span<const glm::dmat3> facesOf(bool directional) {
    static const std::array<glm::dmat3, 1> one{glm::dmat3(1.0)};
    static const std::array<glm::dmat3, 6> six = directionFaces();
    if (directional) return one;
    return six;
}

/// A point light's: a rotation about no axis of the world.
glm::dmat3 pointAxes() {
    static const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0)));
    return turned;
}

glm::dmat3 directionalAxes(const glm::dvec3& toLight) {
    const auto along = axesAlong(toLight);
    const double cosine = std::cos(0.47), sine = std::sin(0.47);
    return glm::transpose(glm::dmat3(cosine * along[0] - sine * along[1],
                                     -sine * along[0] - cosine * along[1], glm::dvec3(0.0)));
}

} // namespace

LightView::LightView(const Light& light)
    : directional(light.position.w == 0.0), origin(directional ? glm::dvec3(0.0) : light.position),
      range(light.hasRange() ? light.range : std::numeric_limits<double>::infinity()),
      axes(directional ? directionalAxes(unitOf(light.position)) : pointAxes()),
      faces(facesOf(directional)) {}

} // namespace edgeshade
