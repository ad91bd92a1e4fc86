#include "src/lab/pixel_surfaces.hpp"

#include "src/lab/all_pixels.hpp"

#include <algorithm>

namespace edgeshade::lab {
namespace {

PixelSurface surfaceAt(const Oracle& oracle, double x, double y) {
    const std::vector<Oracle::Hit> hits = oracle.surfacesAt(x, y);
    if (hits.empty()) return {};
    // Takes the first of coinciding surfaces, as drawing does.
    const auto nearest =
        std::min_element(hits.begin(), hits.end(), [](const auto& a, const auto& b) {
            return std::pair(a.depth, a.triangle) < std::pair(b.depth, b.triangle);
        });
    return {nearest->triangle,
            footprintArea(oracle.question(), oracle.triangles()[nearest->triangle],
                          pixelRay(oracle.question(), x, y), nearest->depth)};
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
