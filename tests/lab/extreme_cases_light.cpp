#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"

namespace edgeshade::test {
namespace {

Extreme litFrom(const std::string& name, const std::string& provokes,
                const std::vector<Light>& lights) {
    return {.name = name, .provokes = provokes, .load = later(yard), .lights = lights};
}

/// The same for a yard that is rotated and moved by ordinary numbers, with a light placed alike.
Extreme litFromTurned(const std::string& name, const std::string& provokes, const Light& light) {
    return {.name = name,
            .provokes = provokes,
            .load = turnedYard,
            .lights = {{ordinaryPlace() * light.position}}};
}

Light spotAt(const glm::dvec3& place, const glm::dvec3& towards, double outer, double inner) {
    Light light = pointLight(place);
    light.cone = Cone{glm::normalize(towards - place), inner, outer};
    return light;
}

/// Point lights and suns on all sides.
std::vector<Light> eightLights() {
    return {pointLight({0.3, 4, 0.7}),  pointLight({-4, 2, 3}),   pointLight({3, 1.2, -3}),
            pointLight({-1.5, 0.2, 1}), pointLight({0, 12, 0.5}), sun({0.4, 1, 0.3}),
            sun({-0.7, 0.5, 0.1}),      sun({0.1, 0.3, -1})};
}

} // namespace

std::vector<Extreme> lightExtremes() {
    const glm::dvec3 eye = Extreme().camera.from;
    return {
        litFrom("light at a vertex", "signs of exactly 0", {pointLight({1.5, 1, 2})}),
        litFrom("light on an edge", "signs of exactly 0", {pointLight({1.5, 1, 1.1})}),
        litFrom("light in a face's plane", "signs of exactly 0", {pointLight({4, 1, 3})}),
        litFrom("light 1e-6 above a face", "signs next to 0", {pointLight({1, 1.000001, 1.2})}),
        litFromTurned("light at a turned vertex", "signs of rounding alone",
                      pointLight({1.5, 1, 2})),
        litFromTurned("light on a turned edge", "signs of rounding alone",
                      pointLight({1.5, 1, 1.1})),
        litFromTurned("light on a turned face", "signs of rounding alone", pointLight({1, 1, 1.2})),
        litFromTurned("light in a turned face's plane", "signs of rounding alone",
                      pointLight({4, 1, 3})),
        litFromTurned("light 1e-5 above a turned face", "signs next to 0",
                      pointLight({1, 1.00001, 1.2})),
        litFromTurned("sun in turned walls", "surfaces on neither side", sun({0, 1, 0})),
        litFrom("light inside a closed mesh", "all outside in shadow",
                {pointLight({-1.5, 1, -0.5})}),
        litFrom("light at 1e9", "a point light like a sun", {pointLight({4e8, 1e9, 3e8})}),
        litFrom("light at infinity", "points at infinity", {sun({0.4, 1, 0.3})}),
        litFrom("sun in the floor's plane", "signs of exactly 0", {sun({1, 0, 0.3})}),
        litFrom("light at the eye", "no shadow is seen", {pointLight(eye)}),
        litFrom("spot", "the edge of a cone", {spotAt({0.6, 5, 0.3}, {0, 0, 0}, 0.4, 0.2)}),
        litFrom("spot of one angle", "a hard edge", {spotAt({0.6, 5, 0.3}, {0, 0, 0}, 0.4, 0.4)}),
        litFrom("spot of 90 degrees", "a cone that is a plane",
                {spotAt({0.6, 1.5, 0.3}, {3, 2, 1}, 1.5707963267948966, 0.5)}),
        litFrom("spot of 1e-6 from 1e6", "angles that floats can't hold",
                {spotAt({4e5, 8e5, 3e5}, {0, 0.5, 0}, 2e-6, 1e-6)}),
        litFrom("spot inside a closed mesh", "all of its cone in shadow",
                {spotAt({-1.5, 1, -0.5}, {0, 1, 0}, 0.7, 0.3)}),
        litFrom("8 lights", "counts and colours of several passes", eightLights()),
    };
}

} // namespace edgeshade::test
