#include "preprocess/scene/vertex_transform.hpp"

#include <cmath>

namespace edgeshade {

glm::vec3 transformedNormal(const glm::dmat3& matrix, const glm::dvec3& normal) {
    const glm::dmat3 cofactors(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1]));
    const double sign = glm::dot(matrix[0], cofactors[0]) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 result = sign * (cofactors * normal);
    const double length = glm::length(result);
    const bool hasDirection = length > 0.0 && std::isfinite(length);
    return hasDirection ? glm::vec3(result / length) : glm::vec3(0.0f);
}

glm::vec4 transformedTangent(const glm::dmat3& matrix, const glm::dvec3& tangent, float sign) {
    const glm::dvec3 along = matrix * tangent;
    const double length = glm::length(along);
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
    const bool turned = (glm::determinant(matrix) < 0.0) != (sign < 0.0f);
    return {glm::vec3(along / length), turned ? -1.0f : 1.0f};
}

glm::vec3 faceNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

} // namespace edgeshade
