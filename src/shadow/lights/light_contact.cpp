#include "src/shadow/lights/light_contact.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Half a unit in the last place of 1.
double roundingUnit(int mantissaBits) {
    return std::ldexp(0.5, -mantissaBits);
}

/// Bounds of rounding in floats. placingUnits: units of the coordinates by which a vertex and the
/// light move apart. dotUnits: units of the terms of dot(plane, light), for a device's evaluation:
/// three products and three sums, and one more for planes that neighbours share (docs/method.md, C4
/// and C24).
constexpr double placingUnits = 4.0, dotUnits = 7.0;

double largestOf(const std::array<glm::dvec3, 3>& corners) {
    return std::max(
        {largestComponent(corners[0]), largestComponent(corners[1]), largestComponent(corners[2])});
}

Box boxAround(const std::array<glm::dvec3, 3>& corners) {
    return {glm::min(glm::min(corners[0], corners[1]), corners[2]),
            glm::max(glm::max(corners[0], corners[1]), corners[2])};
}

/// The most by which rounding may move apart a light and a triangle with such coordinates.
double mostRoom(double coordinates, int mantissaBits) {
    // The three terms of a unit normal, and likewise the plane's offset, are at most sqrt(3) times
    // the coordinates. As they are rounded, dot products may be off by two more units.
    constexpr double mostTerms = 2.0 * 1.7320508075688772;
    return roundingUnit(mantissaBits) * coordinates * (placingUnits + (dotUnits + 2.0) * mostTerms);
}

/// Whether a point of the plane is within the triangle, or outside it by at most `room`.
bool isWithin(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal,
              const glm::dvec3& point, double room) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
        const double inwards = glm::dot(glm::cross(normal, edge), point - corners[i]);
        if (inwards < -room * glm::length(edge)) return false;
    }
    return true;
}

/// dot(plane, light) evaluated in floats, and the sum of its terms' magnitudes.
struct Evaluated {
    double value, terms;
};

Evaluated evaluated(const glm::dvec3& normal, double offset, const glm::dvec3& light) {
    const glm::dvec3 products = glm::dvec3(glm::vec3(normal)) * glm::dvec3(glm::vec3(light));
    const double constant = static_cast<float>(offset);
    return {products.x + products.y + products.z + constant,
            std::abs(products.x) + std::abs(products.y) + std::abs(products.z) +
                std::abs(constant)};
}

} // namespace

bool mayTouch(const Box& box, const glm::dvec4& light, int mantissaBits) {
    if (light.w == 0.0 || box.empty()) return false;
    const glm::dvec3 place = glm::dvec3(light) / light.w;
    const double largest = std::max(largestComponent(box.low), largestComponent(box.high));
    const double reach = mostRoom(std::max(largest, largestComponent(place)), mantissaBits);
    return box.distanceTo(place) <= reach;
}

LightContact contactOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light,
                       int mantissaBits) {
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = glm::length(across), reach = glm::length(glm::dvec3(light));
    if (!(size > 0.0) || !(reach > 0.0 || light.w != 0.0)) return {};
    const glm::dvec3 normal = across / size;
    LightContact contact;
    if (light.w == 0.0) {
        contact.grazes = grazesFrom(normal, glm::dvec3(light));
        return contact;
    }
    const glm::dvec3 place = glm::dvec3(light) / light.w;
    const double height = glm::dot(normal, place - corners[0]);
    const double coordinates = std::max(largestComponent(place), largestOf(corners));
    if (std::abs(height) <= mostRoom(coordinates, mantissaBits)) {
        const double unit = roundingUnit(mantissaBits);
        const Evaluated seen = evaluated(normal, -glm::dot(normal, corners[0]), place);
        const double rounding = dotUnits * unit * seen.terms;
        const bool told = std::abs(seen.value) > rounding && seen.value * height > 0.0;
        const double room = std::max(unit * placingUnits * coordinates, told ? 0.0 : rounding);
        contact.touches = (std::abs(height) <= unit * placingUnits * coordinates || !told) &&
                          isWithin(corners, normal, place, room);
        if (contact.touches)
            contact.reach =
                std::abs(seen.value) + std::max(2.0 * rounding, unit * placingUnits * coordinates);
    }
    contact.grazes =
        contact.touches ||
        std::abs(height) <= LightContact::grazingSine * boxAround(corners).distanceTo(place);
    return contact;
}

double contactReachOf(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                      const glm::dvec4& light) {
    double reach = 0.0;
    if (light.w == 0.0) return reach;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::array<glm::dvec3, 3> corners = {positions[indices[i]], positions[indices[i + 1]],
                                                   positions[indices[i + 2]]};
        if (mayTouch(boxAround(corners), light))
            reach = std::max(reach, contactOf(corners, light).reach);
    }
    return reach;
}

} // namespace edgeshade
