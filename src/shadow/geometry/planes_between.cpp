#include "src/shadow/geometry/planes_between.hpp"

#include "src/shadow/geometry/box_plane.hpp"

namespace edgeshade {
namespace {

/// Planes along the axes: of the box, moved out to the light.
void addAlongAxes(const glm::dvec4& light, const Box& box, std::vector<glm::dvec4>& planes) {
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0);
            normal[axis] = sign;
            glm::dvec4 plane = planeAround(box, normal);
            const double atLight = glm::dot(plane, light);
            if (light.w == 0.0 && atLight < 0.0) continue; // the hull has no end on this side
            if (light.w != 0.0 && atLight < 0.0) plane.w -= atLight / light.w;
            planes.push_back(plane);
        }
}

/// Whether a plane with the box inside has the light inside, too, up to rounding.
bool hasInside(const glm::dvec4& plane, const glm::dvec4& light) {
    const double size = glm::dot(glm::abs(plane), glm::abs(light));
    return glm::dot(plane, light) >= -1e-9 * size;
}

/// Planes along an axis that touch the box at a corner and pass through the light.
void addThroughLight(const glm::dvec4& light, const Box& box, std::vector<glm::dvec4>& planes) {
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < (light.w == 0.0 ? 1 : 8); ++corner) {
            if ((corner >> axis) & 1) continue; // the same plane as that of another corner
            glm::dvec3 along(0.0);
            along[axis] = 1.0;
            const glm::dvec3 normal =
                glm::cross(along, glm::dvec3(light) - light.w * box.corner(corner));
            if (glm::dot(normal, normal) == 0.0) continue;
            for (const double sign : {-1.0, 1.0}) {
                const glm::dvec4 plane = planeAround(box, sign * normal);
                if (hasInside(plane, light)) planes.push_back(plane);
            }
        }
}

} // namespace

void findPlanesBetween(const glm::dvec4& light, const Box& box, std::vector<glm::dvec4>& planes) {
    planes.clear();
    if (box.empty()) return;
    addAlongAxes(light, box, planes);
    addThroughLight(light, box, planes);
}

} // namespace edgeshade
