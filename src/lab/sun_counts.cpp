#include "src/lab/sun_counts.hpp"

#include "src/rays/lit_rays.hpp"

#include <algorithm>

namespace edgeshade::lab {
namespace {

/// Directions whose answers are kept at once, 128 bytes for each pixel.
constexpr std::size_t directionsAtOnce = 1024;
/// Side of the squares of pixels that share a packet of rays.
constexpr std::size_t tile = 4;

/// The pixels that show a surface, in squares of tile x tile, so that neighbours are close
/// together.
std::vector<std::size_t> pixelsInTiles(const Question& question,
                                       std::span<const PixelSurface> surfaces) {
    const auto width = static_cast<std::size_t>(question.width),
               height = static_cast<std::size_t>(question.height);
    std::vector<std::size_t> pixels;
    for (std::size_t top = 0; top < height; top += tile)
        for (std::size_t left = 0; left < width; left += tile)
            for (std::size_t y = top; y < std::min(top + tile, height); ++y)
                for (std::size_t x = left; x < std::min(left + tile, width); ++x)
                    if (surfaces[y * width + x].area > 0.0) pixels.push_back(y * width + x);
    return pixels;
}

} // namespace

std::vector<std::uint16_t> litCounts(const Oracle& oracle, std::span<const PixelSurface> surfaces,
                                     std::span<const glm::dvec3> directions,
                                     const std::function<void(double)>& progress) {
    const Question& question = oracle.question();
    const std::vector<std::size_t> pixels = pixelsInTiles(question, surfaces);
    std::vector<rays::SurfacePoint> points;
    points.reserve(pixels.size());
    for (const std::size_t pixel : pixels) {
        const glm::dvec2 center = centerOf(question, pixel);
        const PixelRay ray = pixelRay(question, center.x, center.y);
        points.push_back({ray.origin, ray.direction, surfaces[pixel].triangle});
    }
    rays::IsHole isHole;
    if (question.cutoutsCast)
        isHole = [&oracle](const SurfaceTriangle& triangle, double u, double v) {
            return oracle.isHole(triangle, u, v);
        };
    const rays::LitRays rays(*question.scene, oracle.surfaces(), isHole);
    std::vector<std::uint16_t> counts(surfaces.size(), 0);
    for (std::size_t first = 0; first < directions.size(); first += directionsAtOnce) {
        const std::size_t count = std::min(directionsAtOnce, directions.size() - first);
        const rays::LitBits lit =
            rays.lit(points, directions.subspan(first, count), {}, [&](double share) {
                progress((static_cast<double>(first) + share * static_cast<double>(count)) /
                         static_cast<double>(directions.size()));
            });
        for (std::size_t i = 0; i < pixels.size(); ++i)
            counts[pixels[i]] = static_cast<std::uint16_t>(counts[pixels[i]] + lit.count(i));
    }
    return counts;
}

} // namespace edgeshade::lab
