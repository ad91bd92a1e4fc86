#include "src/shadow/lights/light_in_batch.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <cmath>

namespace edgeshade {
namespace {

double frobeniusNorm(const glm::dmat3& matrix) {
    return std::sqrt(glm::dot(matrix[0], matrix[0]) + glm::dot(matrix[1], matrix[1]) +
                     glm::dot(matrix[2], matrix[2]));
}

} // namespace

LightInBatch lightInBatch(const Light& light, const glm::dmat4& worldFromBatch) {
    const glm::dmat4 inverse = glm::inverse(worldFromBatch);
    LightInBatch result{inverse * light.position};
    // Transformed back, it misses the light by the matrix times its error. The last two terms are
    // the rounding of that transform.
    const glm::dvec3 miss(worldFromBatch * result.place - light.position);
    const double terms = frobeniusNorm(glm::dmat3(worldFromBatch)) * result.length() +
                         light.position.w * glm::length(glm::dvec3(worldFromBatch[3])) +
                         glm::length(glm::dvec3(light.position));
    result.rounding =
        2.0 * frobeniusNorm(glm::dmat3(inverse)) * (glm::length(miss) + 0x1p-50 * terms);
    result.place.w = light.position.w;
    if (light.position.w != 0.0) return result;
    // Keeps squares of it within the range of floats.
    const double largest = largestComponent(glm::dvec3(result.place));
    result.place /= largest;
    result.rounding /= largest;
    return result;
}

} // namespace edgeshade
