#include "src/lab/pixel_surfaces.hpp"

#include "src/lab/all_pixels.hpp"
#include "src/lab/exact_judge.hpp"

#include <algorithm>

namespace edgeshade::lab {
namespace {

PixelSurface surfaceAt(const Oracle& oracle, double x, double y) {
    const auto seen = [&](std::uint32_t triangle, double depth) -> PixelSurface {
        return {triangle, footprintArea(oracle.question(), oracle.triangles()[triangle],
                                        pixelRay(oracle.question(), x, y), depth)};
    };
    const Oracle::First first = oracle.firstAt(x, y);
    if (first.certainPlaces) // alpha is interpolated, so integers would not make it exact
        return first.hit ? seen(first.hit->triangle, first.hit->depth) : PixelSurface();
    const std::optional<ExactSurface> exact = surfaceExactly(oracle, x, y);
    return exact ? seen(exact->triangle, exact->depth) : PixelSurface();
}

} // namespace

double footprintArea(const Question& question, const SurfaceTriangle& triangle, const PixelRay& ray,
                     double depth) {
    const glm::dvec2 window = question.frustum.size();
    const double pixel =
        window.x * window.y / (static_cast<double>(question.width) * question.height);
    const glm::dvec3 normal = normalOf(triangle);
    const double along = glm::length(ray.direction);
    const double length = glm::length(normal) * along;
    if (length == 0.0) return 0.0;
    const double cosine = std::max(std::abs(glm::dot(normal, ray.direction)) / length, leastCosine);
    // In perspective the image plane is at depth 1, slanted to the ray by 1 / along.
    const double acrossRay = question.frustum.orthographic ? pixel : pixel * depth * depth / along;
    return acrossRay / cosine;
}

std::vector<PixelSurface> pixelSurfaces(const Oracle& oracle,
                                        const std::function<void(double)>& progress) {
    return atAllPixels(
        oracle.question().width, oracle.question().height,
        [&](double x, double y) { return surfaceAt(oracle, x, y); }, progress);
}

} // namespace edgeshade::lab
