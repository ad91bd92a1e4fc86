#include "src/city/geodetic.hpp"

#include <cmath>

namespace edgeshade::city {
namespace {

// WGS 84's ellipsoid.
constexpr double semiMajor = 6378137.0;
constexpr double flattening = 1.0 / 298.257223563;

} // namespace

sun::Place placeOfEcef(const glm::dvec3& point) {
    constexpr double semiMinor = semiMajor * (1.0 - flattening);
    constexpr double first = flattening * (2.0 - flattening), second = first / (1.0 - first);
    const double fromAxis = std::hypot(point.x, point.y);
    // Bowring's parametric latitude, improved by his formula twice.
    double parametric = std::atan2(semiMajor * point.z, semiMinor * fromAxis);
    double latitude = 0.0;
    for (int i = 0; i < 3; ++i) {
        latitude = std::atan2(point.z + second * semiMinor * std::pow(std::sin(parametric), 3.0),
                              fromAxis - first * semiMajor * std::pow(std::cos(parametric), 3.0));
        parametric = std::atan2((1.0 - flattening) * std::sin(latitude), std::cos(latitude));
    }
    return {glm::degrees(latitude), glm::degrees(std::atan2(point.y, point.x))};
}

glm::dvec3 ecefOf(const sun::Place& place, double height) {
    const double latitude = glm::radians(place.latitude), longitude = glm::radians(place.longitude);
    const double sinLat = std::sin(latitude), cosLat = std::cos(latitude);
    constexpr double first = flattening * (2.0 - flattening);
    const double toAxis = semiMajor / std::sqrt(1.0 - first * sinLat * sinLat);
    return {(toAxis + height) * cosLat * std::cos(longitude),
            (toAxis + height) * cosLat * std::sin(longitude),
            (toAxis * (1.0 - first) + height) * sinLat};
}

glm::dmat4 ecefFromEastNorthUp(const glm::dvec3& origin) {
    const sun::Place place = placeOfEcef(origin);
    const double latitude = glm::radians(place.latitude), longitude = glm::radians(place.longitude);
    const double sinLat = std::sin(latitude), cosLat = std::cos(latitude);
    const double sinLon = std::sin(longitude), cosLon = std::cos(longitude);
    return {{-sinLon, cosLon, 0.0, 0.0},
            {-sinLat * cosLon, -sinLat * sinLon, cosLat, 0.0},
            {cosLat * cosLon, cosLat * sinLon, sinLat, 0.0},
            {origin, 1.0}};
}

glm::dmat4 rigidInverse(const glm::dmat4& transform) {
    const glm::dmat3 turned = glm::transpose(glm::dmat3(transform));
    glm::dmat4 inverse(turned);
    inverse[3] = glm::dvec4(-(turned * glm::dvec3(transform[3])), 1.0);
    return inverse;
}

} // namespace edgeshade::city
