#include "src/bench/scattered_lights.hpp"

#include "src/shadow/geometry/quasirandom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace edgeshade::bench {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr double facesUp = 0.5;                ///< least height of a unit normal
constexpr double aboveFloor = 0.25;            ///< share of the range
constexpr double hueStep = 0.6180339887498949; ///< between neighbours, as a share of the circle

/// Triangles, and the area of each with all before it.
struct Floor {
    std::vector<Corners> triangles;
    std::vector<double> areas;

    double area() const { return areas.empty() ? 0.0 : areas.back(); }
};

Floor floorOf(const Scene& scene, double leastHeight) {
    Floor floor;
    double area = 0.0;
    for (const Batch& batch : scene.batches) {
        if (batch.ground) continue;
        const auto& indices = batch.geometry->indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            Corners corners;
            for (std::size_t c = 0; c < 3; ++c)
                corners[c] = glm::dvec3(batch.worldFromBatch *
                                        glm::dvec4(batch.geometry->positions[indices[i + c]], 1.0));
            const glm::dvec3 cross = (batch.isMirrored() ? -1.0 : 1.0) *
                                     glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double size = glm::length(cross);
            if (!(size > 0.0) || cross.y < leastHeight * size) continue;
            area += 0.5 * size;
            floor.triangles.push_back(corners);
            floor.areas.push_back(area);
        }
    }
    return floor;
}

/// A linear colour, fully bright and half saturated. `hue`: a share of the circle.
glm::vec3 colorOf(double hue) {
    glm::vec3 color;
    for (glm::length_t c = 0; c < 3; ++c) {
        const double away = std::abs(std::fmod(6.0 * hue + 6.0 - 2.0 * c, 6.0) - 3.0);
        color[c] = static_cast<float>(1.0 - 0.5 * std::clamp(2.0 - away, 0.0, 1.0));
    }
    return color;
}

/// A point of the floor, chosen by three numbers in [0, 1).
glm::dvec3 pointOn(const Floor& floor, const std::array<double, 3>& place) {
    const auto found =
        std::upper_bound(floor.areas.begin(), floor.areas.end(), place[0] * floor.area());
    const auto index =
        std::min(static_cast<std::size_t>(found - floor.areas.begin()), floor.triangles.size() - 1);
    const Corners& corners = floor.triangles[index];
    const double root = std::sqrt(place[1]);
    return (1.0 - root) * corners[0] + root * (1.0 - place[2]) * corners[1] +
           root * place[2] * corners[2];
}

} // namespace

std::vector<Light> scatterLights(const Scene& scene, std::size_t count) {
    Floor floor = floorOf(scene, facesUp);
    if (floor.triangles.empty()) floor = floorOf(scene, -1.0);
    std::vector<Light> lights;
    if (floor.triangles.empty()) return std::vector<Light>(count, Light{glm::dvec4(0, 1, 0, 1)});
    const double diagonal = worldBounds(scene).diagonal();
    const double range =
        std::min(diagonal, std::sqrt(overlappingLights * floor.area() /
                                     (std::numbers::pi * static_cast<double>(count))));
    for (std::size_t i = 0; i < count; ++i) {
        Light light;
        glm::dvec3 place = pointOn(floor, evenly<3>(i + 1));
        place.y += aboveFloor * range;
        light.position = glm::dvec4(place, 1.0);
        light.range = range;
        const double candela = 0.5 * std::numbers::pi * std::pow(aboveFloor * range, 2.0);
        light.color =
            static_cast<float>(candela) * colorOf(std::fmod(hueStep * static_cast<double>(i), 1.0));
        light.photometric = true;
        lights.push_back(light);
    }
    return lights;
}

} // namespace edgeshade::bench
