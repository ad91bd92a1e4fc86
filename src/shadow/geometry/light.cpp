#include "src/shadow/geometry/light.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

void requireFewLights(std::size_t lights) {
    if (lights > mostLights)
        throw Error(ExitStatus::usage, "More than " + std::to_string(mostLights) +
                                           " lights were asked for, but a picture has " +
                                           std::to_string(mostLights) + " at most.");
}

Light defaultLight() {
    return {glm::dvec4(0.6, 1.0, 0.35, 0.0)};
}

glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject) {
    glm::dvec4 inObject = glm::inverse(worldFromObject) * light.position;
    if (light.position.w == 0.0) {
        // Only the direction counts: scaled so that no square of it leaves the range of floats.
        inObject /= std::max({std::abs(inObject.x), std::abs(inObject.y), std::abs(inObject.z)});
        inObject.w = 0.0;
    }
    return glm::vec4(inObject);
}

} // namespace edgeshade
