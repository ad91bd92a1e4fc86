#include "src/shadow/lights/light.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

void requireFewLights(std::size_t lights) {
    if (lights > mostLights)
        throw Error(ExitStatus::usage, "More than " + std::to_string(mostLights) +
                                           " lights were requested, but a picture has at most " +
                                           std::to_string(mostLights) + ".");
}

Light defaultLight() {
    return {glm::dvec4(0.6, 1.0, 0.35, 0.0)};
}

glm::dvec4 placeInObject(const Light& light, const glm::dmat4& worldFromObject) {
    return placeByInverse(light, glm::inverse(worldFromObject));
}

glm::dvec4 placeByInverse(const Light& light, const glm::dmat4& objectFromWorld) {
    glm::dvec4 inObject = objectFromWorld * light.position;
    if (light.position.w == 0.0) {
        // Keeps squares of it within the range of floats.
        inObject /= largestComponent(glm::dvec3(inObject));
        inObject.w = 0.0;
    }
    return inObject;
}

glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject) {
    return glm::vec4(placeInObject(light, worldFromObject));
}

double rangeInObject(double range, const glm::dmat4& worldFromObject) {
    // The largest stretch of a length from the world to the object's space: the root of the largest
    // eigenvalue of A^T A, bounded from above by the largest sum of absolute values in a row. The
    // bound is exact for rotations and for scales along the axes.
    const glm::dmat3 a = glm::inverse(glm::dmat3(worldFromObject));
    const glm::dmat3 squared = glm::transpose(a) * a;
    double largest = 0.0;
    for (glm::length_t i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(squared[i].x) + std::abs(squared[i].y) +
                                        std::abs(squared[i].z));
    return range * std::sqrt(largest);
}

double rangeInObject(const Light& light, const glm::dmat4& worldFromObject) {
    return light.hasRange() ? rangeInObject(light.range, worldFromObject)
                            : std::numeric_limits<double>::infinity();
}

} // namespace edgeshade
