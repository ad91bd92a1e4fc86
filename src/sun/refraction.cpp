#include "src/sun/refraction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeshade::sun {

double refraction(double altitude, const Atmosphere& air) {
    const double lowest = -1.0, none = -5.0;
    const double at = std::max(altitude, lowest);
    const double degree = std::numbers::pi / 180.0;
    const double arcMinutes = 1.02 / std::tan((at + 10.3 / (at + 5.11)) * degree);
    const double density = air.pressure / 1010.0 * 283.0 / (273.0 + air.temperature);
    const double faded = std::clamp((altitude - none) / (lowest - none), 0.0, 1.0);
    return std::max(arcMinutes, 0.0) / 60.0 * density * faded; // slightly below 0 in the zenith
}

} // namespace edgeshade::sun
