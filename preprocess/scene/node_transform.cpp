#include "preprocess/scene/node_transform.hpp"

#include "preprocess/scene/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

double largestOf(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Of length 1, whatever its size; null for nothing and for what is not finite.
std::optional<glm::dvec3> unit(const glm::dvec3& v) {
    const double largest = largestOf(v);
    if (!isFinite(v) || largest == 0.0) return std::nullopt;
    return glm::normalize(v / largest);
}

} // namespace

glm::dmat4 NodeTransform::matrix() const {
    glm::dmat4 parentFromNode = glm::mat4_cast(rotation);
    for (glm::length_t c = 0; c < 3; ++c)
        parentFromNode[c] *= scale[c];
    parentFromNode[3] = glm::dvec4(translation, 1.0);
    return parentFromNode;
}

std::optional<glm::dvec3> originOf(const glm::dmat4& transform) {
    const glm::dvec3 origin(transform[3]);
    if (!isFinite(origin) || largestOf(origin) > farthestPlace) return std::nullopt;
    return origin;
}

std::optional<glm::dmat3> turnOf(const glm::dmat4& transform) {
    const auto back = unit(glm::dvec3(transform[2])), upward = unit(glm::dvec3(transform[1]));
    if (!back || !upward) return std::nullopt;
    const auto right = unit(glm::cross(*upward, *back));
    if (!right) return std::nullopt;
    return glm::dmat3(*right, glm::cross(*back, *right), *back);
}

} // namespace edgeshade
