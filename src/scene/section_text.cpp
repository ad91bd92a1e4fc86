#include "src/scene/section_text.hpp"

#include "preprocess/base/vectors.hpp"
#include "src/scene/color_text.hpp"

#include <cmath>

namespace edgeshade {

bool isSectionPlane(const glm::dvec4& plane) {
    return isFinite(glm::dvec3(plane)) && std::isfinite(plane.w) &&
           glm::dvec3(plane) != glm::dvec3(0.0);
}

std::vector<glm::dvec4> sectionBox(const glm::dvec3& low, const glm::dvec3& high) {
    std::vector<glm::dvec4> planes;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::dvec4 plane(0.0);
        plane[axis] = 1.0;
        plane.w = -low[axis];
        planes.push_back(plane);
        plane[axis] = -1.0;
        plane.w = high[axis];
        planes.push_back(plane);
    }
    return planes;
}

std::optional<std::optional<glm::vec3>> fillFromText(const std::string& text) {
    if (text == "none") return std::optional<glm::vec3>();
    if (const auto color = linearFromText(text)) return std::optional(*color);
    return std::nullopt;
}

std::string textOfFill(const std::optional<glm::vec3>& fill) {
    return fill ? textFromLinear(*fill) : "none";
}

} // namespace edgeshade
