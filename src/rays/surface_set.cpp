#include "src/rays/surface_set.hpp"

#include <numeric>

namespace edgeshade::rays {
namespace {

std::vector<Corners> cornersOf(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<Corners> corners;
    corners.reserve(triangles.size());
    for (const SurfaceTriangle& triangle : triangles)
        corners.push_back({triangle.a, triangle.b, triangle.c});
    return corners;
}

/// Whether each of `count` triangles casts; those after `triangles` all do.
std::vector<std::uint8_t> castsOf(const std::vector<SurfaceTriangle>& triangles,
                                  std::size_t count) {
    std::vector<std::uint8_t> casts(count, 1);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        casts[i] = triangles[i].casts;
    return casts;
}

std::vector<std::uint32_t> numbersTo(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

} // namespace

SurfaceSet::SurfaceSet(std::vector<SurfaceTriangle> all)
    : triangles(std::move(all)), corners(cornersOf(triangles)),
      casts(castsOf(triangles, corners.size())), tree(corners, numbersTo(corners.size())) {}

SurfaceSet::SurfaceSet(std::vector<SurfaceTriangle> surfaces, std::vector<Corners> all)
    : triangles(std::move(surfaces)), corners(std::move(all)),
      casts(castsOf(triangles, corners.size())), tree(corners, numbersTo(corners.size())) {}

} // namespace edgeshade::rays
