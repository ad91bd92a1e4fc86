#include "src/sun/direction.hpp"

#include <cmath>

namespace edgeshade::sun {

glm::dvec3 towardsSun(const SunPosition& position, double north) {
    const double altitude = glm::radians(position.altitude);
    const double clockwise = glm::radians(position.azimuth + north);
    const double level = std::cos(altitude);
    return {level * std::sin(clockwise), std::sin(altitude), -level * std::cos(clockwise)};
}

} // namespace edgeshade::sun
