#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"

namespace edgeshade::test {
namespace {

const Light lamp = pointLight({0.3, 4, 0.7});

Extreme seenFrom(const std::string& name, const std::string& provokes, const Camera& camera) {
    return {.name = name,
            .provokes = provokes,
            .load = later(yard),
            .camera = camera,
            .lights = {lamp}};
}

/// A close-up from `away` of the yard's size, which is about 15, of a fold of a box that is rotated
/// and moved by ordinary numbers, with a lamp in between.
Extreme closeUp(const std::string& away, double share) {
    const auto placed = [](const glm::dvec3& p) {
        return glm::dvec3(ordinaryPlace() * glm::dvec4(p, 1.0));
    };
    const glm::dvec3 fold(1.5, 1, 1.3);
    const double size = 15.0 * share;
    Extreme extreme;
    extreme.name = "eye " + away + " from a turned fold";
    extreme.provokes = "what rounding leaves of a close-up";
    extreme.load = turnedYard;
    extreme.camera = {placed(fold + size * glm::dvec3(0.6, 0.7, 0.3)),
                      placed(fold + size * glm::dvec3(-0.1, -0.2, 0.1)), 60.0};
    extreme.lights = {pointLight(placed(fold + size * glm::dvec3(0.1, 0.4, -0.2)))};
    return extreme;
}

Extreme picture(const std::string& name, const std::string& provokes, int width, int height) {
    Extreme extreme = seenFrom(name, provokes, Extreme().camera);
    extreme.width = width;
    extreme.height = height;
    return extreme;
}

SceneBuilder openCaster() {
    return SceneBuilder().floor(8).triangle({-1, 1.5f, 4.5f}, {1.2f, 1.4f, 4.4f}, {0.1f, 1.1f, -1});
}
SceneBuilder closedCaster() {
    return SceneBuilder().floor(8).box({-1, 1, 1}, {1, 1.6f, 5});
}

Extreme nearPlaneThrough(const std::string& caster, const std::function<SceneBuilder()>& draw,
                         int slices) {
    const std::string sliced = slices > 1 ? ", " + std::to_string(slices) + " slices" : "";
    return {.name = "near plane through " + caster + " caster" + sliced,
            .provokes = "front caps at infinity of what was clipped",
            .load = later(draw),
            .camera = {{0.2, 2.4, 6.5}, {0, 0.6, 0}, 60.0},
            .lights = {pointLight({0.4, 4, 0.5})},
            .depth = {.near = 3.0, .slices = slices}};
}

Extreme depth16(const std::string& what, const std::function<SceneBuilder()>& draw) {
    return {.name = "16-bit depth, " + what,
            .provokes = "a depth buffer 256 times as coarse",
            .load = later(draw),
            .lights = {lamp},
            .depthBits = 16};
}

} // namespace

std::vector<Extreme> viewExtremes() {
    Extreme dot = seenFrom("a dot 1e-4 before the eye", "depth precision behind it",
                           {{5, 4, 6}, {0, 0.5, 0}, 50.0});
    dot.load = later(yardBehindADot);
    dot.mostWrongPercent = 0.05;
    Extreme largest = picture("4096x4096 picture", "the largest pictures", 4096, 4096);
    largest.takesLong = true;
    return {
        closeUp("1e-2", 1e-2),
        closeUp("1e-3", 1e-3),
        closeUp("1e-4", 1e-4),
        seenFrom("eye in shadow", "eye inside volumes", {{-1.5, 0.2, -0.5}, {1, 0.3, 1}, 70}),
        seenFrom("eye inside a caster", "near plane inside", {{-1.5, 1.2, -0.5}, {1, 1, 1}, 90}),
        seenFrom("eye on a face's plane", "a face edge-on", {{5, 1, 4}, {0, 1, 1}, 60}),
        seenFrom("looking into the light", "volumes towards the eye",
                 {{0, 0.3, 4}, {0.3, 4, 0.7}, 70}),
        seenFrom("looking away from the light", "volumes away",
                 {{0.9, 3.6, 1.3}, {-1.2, 0, -1.5}, 90}),
        seenFrom("straight down", "the vertical view", {{0, 8, 0}, {0, 0, 0}, 60}),
        nearPlaneThrough("an open", openCaster, 1),
        nearPlaneThrough("an open", openCaster, 4),
        nearPlaneThrough("a closed", closedCaster, 1),
        nearPlaneThrough("a closed", closedCaster, 4),
        dot,
        depth16("the yard", yard),
        depth16("fan of 7", [] { return fan(7); }),
        depth16("a dot before the eye", yardBehindADot),
        picture("1x1 picture", "the smallest picture", 1, 1),
        picture("2048x2048 picture", "large pictures", 2048, 2048),
        largest,
    };
}

} // namespace edgeshade::test
