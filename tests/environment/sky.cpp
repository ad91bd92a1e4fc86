#include "tests/environment/sky.hpp"

#include <cmath>
#include <numbers>

namespace edgeshade::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Sums sky * weight(angle to the normal) and divides by the sum of weights, with more steps at
/// small angles.
template <class Weight>
glm::dvec3 zonalMean(const Sky& sky, const glm::dvec3& normal, Weight weight) {
    constexpr int rings = 300, turns = 96;
    const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 across = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 along = glm::cross(normal, across);
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double share = (ring + 0.5) / rings;
        const double angle = 0.5 * pi * share * share;
        const double ringWeight = weight(angle) * std::sin(angle) * share;
        for (int turn = 0; turn < turns; ++turn) {
            const double azimuth = 2.0 * pi * (turn + 0.5 * (ring % 2)) / turns;
            const glm::dvec3 side = across * std::cos(azimuth) + along * std::sin(azimuth);
            sum += ringWeight * sky(normal * std::cos(angle) + side * std::sin(angle));
            weights += ringWeight;
        }
    }
    return sum / weights;
}

} // namespace

glm::dvec3 lopsidedSky(const glm::dvec3& d) {
    const glm::dvec3 towardsSun = glm::normalize(glm::dvec3(0.6, 0.5, -0.4));
    const double sun = 16.0 * std::exp(40.0 * (glm::dot(d, towardsSun) - 1.0));
    return glm::dvec3(0.7 + 0.5 * d.x, 0.8 + 0.3 * d.y + 0.3 * d.x * d.z, 0.9 + 0.6 * d.y * d.z) +
           sun * glm::dvec3(1.0, 0.8, 0.6);
}

std::vector<glm::vec3> testDirections() {
    std::vector<glm::vec3> directions;
    for (const float sign : {-1.0f, 1.0f})
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 direction(0.0f);
            direction[axis] = sign;
            directions.push_back(direction);
            for (const float near : {-1e-3f, 1e-3f}) {
                direction[(axis + 1) % 3] = near;
                directions.push_back(glm::normalize(direction));
            }
        }
    constexpr int count = 30;
    for (int i = 0; i < count; ++i) { // a spiral of the golden angle
        const double height = 1.0 - 2.0 * (i + 0.5) / count;
        const double azimuth = i * pi * (3.0 - std::sqrt(5.0));
        const double level = std::sqrt(1.0 - height * height);
        directions.emplace_back(level * std::cos(azimuth), height, level * std::sin(azimuth));
    }
    return directions;
}

glm::dvec3 lambertByBruteForce(const Sky& sky, const glm::dvec3& normal) {
    return zonalMean(sky, normal, [](double angle) { return std::cos(angle); });
}

glm::dvec3 ggxByBruteForce(const Sky& sky, const glm::dvec3& normal, double roughness) {
    const double alpha = roughness * roughness;
    return zonalMean(sky, normal, [&](double angle) {
        const double halfTangent = std::tan(0.5 * angle), halfCosine = std::cos(0.5 * angle);
        // As in Walter et al. 2007, without constant factors.
        const double width = alpha * alpha + halfTangent * halfTangent;
        return std::cos(angle) / (std::pow(halfCosine, 4.0) * width * width);
    });
}

glm::dvec3 meanOf(const Sky& sky) {
    constexpr int rings = 500, turns = 300;
    glm::dvec3 sum(0.0);
    for (int ring = 0; ring < rings; ++ring)
        for (int turn = 0; turn < turns; ++turn) {
            const double height = 1.0 - 2.0 * (ring + 0.5) / rings;
            const double azimuth = 2.0 * pi * turn / turns;
            const double level = std::sqrt(1.0 - height * height);
            sum += sky({level * std::cos(azimuth), height, level * std::sin(azimuth)});
        }
    return sum / double(rings * turns);
}

} // namespace edgeshade::test
