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

std::vector<std::uint8_t> castsOf(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<std::uint8_t> casts;
    casts.reserve(triangles.size());
    for (const SurfaceTriangle& triangle : triangles)
        casts.push_back(triangle.casts);
    return casts;
}

std::vector<std::uint32_t> numbersTo(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

} // namespace

SurfaceSet::SurfaceSet(std::vector<SurfaceTriangle> all)
    : triangles(std::move(all)), corners(cornersOf(triangles)), casts(castsOf(triangles)),
      tree(corners, numbersTo(corners.size())) {}

} // namespace edgeshade::rays
