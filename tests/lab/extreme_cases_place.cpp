#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::test {
namespace {

const Camera corner = Extreme().camera;
const glm::dvec3 lamp(0.3, 4, 0.7);

std::function<LoadedScene()> yardPlacedBy(const glm::dmat4& matrix) {
    return later([matrix] { return yard().placedBy(matrix); });
}

Extreme scaled(const std::string& scale, double s) {
    return {.name = "scale " + scale,
            .provokes = "float range and rounding at other units",
            .load = yardPlacedBy(glm::scale(glm::dmat4(1.0), glm::dvec3(s))),
            .camera = {s * corner.from, s * corner.to, corner.fovDegrees},
            .lights = {pointLight(s * lamp)}};
}

Extreme bakedScale(const std::string& scale, float s) {
    // The vertices are scaled, so that the scale reaches the shaders.
    return {.name = "vertices at scale " + scale,
            .provokes = "float range of products in the shaders",
            .load =
                [s] {
                    Scene scene = yard().scene();
                    for (glm::vec3& position : scene.batches.front().geometry.edit().positions)
                        position *= s;
                    return loaded(std::move(scene));
                },
            .camera = {double{s} * corner.from, double{s} * corner.to, corner.fovDegrees},
            .lights = {pointLight(double{s} * lamp)}};
}

glm::dvec3 farOff(double distance) {
    return {distance, 0.5 * distance, -distance};
}

Extreme atOrigin(const std::string& name, double distance) {
    const glm::dvec3 offset = farOff(distance);
    return {.name = "origin " + name,
            .provokes = "cancellation in survey coordinates",
            .load = yardPlacedBy(glm::translate(glm::dmat4(1.0), offset)),
            .camera = {corner.from + offset, corner.to + offset, corner.fovDegrees},
            .lights = {pointLight(lamp + offset)}};
}

Extreme detailAt(const std::string& name, double distance) {
    const glm::dvec3 offset = farOff(distance);
    return {.name = "1e-3 detail at " + name,
            .provokes = "detail below a float's step out there",
            .load = [offset] { return tinyBoxesAt(offset); },
            .camera = {1e-3 * corner.from + offset, 1e-3 * corner.to + offset, corner.fovDegrees},
            .lights = {pointLight(1e-3 * lamp + offset)}};
}

Extreme placed(const std::string& name, const std::string& provokes, const glm::dmat4& matrix) {
    return {.name = name,
            .provokes = provokes,
            .load = yardPlacedBy(matrix),
            .lights = {pointLight(glm::dvec3(matrix * glm::dvec4(lamp, 1.0)))}};
}

} // namespace

std::vector<Extreme> placeExtremes() {
    glm::dmat4 sheared(1.0);
    sheared[1][0] = 0.7;
    const glm::dmat4 flattened = glm::scale(glm::dmat4(1.0), {1, 1e-2, 1e2});
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), {-1, 1, 1});
    return {
        scaled("1e-6", 1e-6),
        scaled("1e-3", 1e-3),
        scaled("1e3", 1e3),
        scaled("1e6", 1e6),
        bakedScale("1e-6", 1e-6f),
        bakedScale("1e6", 1e6f),
        atOrigin("1e5", 1e5),
        atOrigin("1e6", 1e6),
        atOrigin("1e7", 1e7),
        detailAt("1e5", 1e5),
        detailAt("1e6", 1e6),
        detailAt("1e7", 1e7),
        {.name = "1e-3 detail on a floor of 10",
         .provokes = "four orders of size in one mesh",
         .load = later(tinyYard),
         .camera = {1e-3 * corner.from, 1e-3 * corner.to, corner.fovDegrees},
         .lights = {pointLight(1e-3 * lamp)}},
        placed("mirrored node", "windings turned over", mirrored),
        placed("sheared node", "light by the inverse", sheared),
        placed("node scaled 1e4:1", "light by the inverse", flattened),
        placed("mirrored, sheared, 1e4:1", "all of them at once", mirrored * sheared * flattened),
    };
}

} // namespace edgeshade::test
