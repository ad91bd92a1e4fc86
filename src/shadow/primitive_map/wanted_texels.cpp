#include "src/shadow/primitive_map/wanted_texels.hpp"

#include "src/shadow/primitive_map/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

WantedTexels::WantedTexels(const LightTiles& tiles, std::size_t tile, int size,
                           std::span<const WorldTriangle> triangles)
    : size_(size) {
    const auto corners = static_cast<std::size_t>(size + 1);
    sums_.resize(corners * corners);
    for (const WorldTriangle& triangle : triangles) {
        std::array<glm::dvec3, 3> inMap;
        std::transform(triangle.begin(), triangle.end(), inMap.begin(), [&](const glm::dvec3& p) {
            return glm::dvec3(tiles.mapFromWorld * glm::dvec4(p, 1.0));
        });
        if (const auto rays = raysTo(inMap, tiles, tile)) add(*rays);
    }
    // From the changes at the rectangles' corners to how many hold each texel, one after it.
    for (int y = 0; y < size; ++y)
        for (int x = 1; x < size; ++x)
            sumAt(x, y) += sumAt(x - 1, y);
    for (int y = 1; y < size; ++y)
        for (int x = 0; x < size; ++x)
            sumAt(x, y) += sumAt(x, y - 1);
    for (int y = size; y >= 0; --y)
        for (int x = size; x >= 0; --x)
            sumAt(x, y) = x > 0 && y > 0 && sumAt(x - 1, y - 1) > 0 ? 1 : 0;
    for (int y = 1; y <= size; ++y)
        for (int x = 1; x <= size; ++x)
            sumAt(x, y) += sumAt(x - 1, y) + sumAt(x, y - 1) - sumAt(x - 1, y - 1);
}

/// Adds one to the texels that the rays may be in: notes at the corners of that rectangle how the
/// number changes there.
void WantedTexels::add(const RaySquare& rays) {
    const auto texelAt = [&](double at) {
        return static_cast<int>(
            std::clamp(std::floor((at + 1.0) * 0.5 * size_), -1.0, static_cast<double>(size_)));
    };
    const RaySquare grown = rays.grownBy(2.0 * mapRounding);
    const int left = std::max(0, texelAt(grown.low.x)), low = std::max(0, texelAt(grown.low.y));
    const int right = std::min(size_ - 1, texelAt(grown.high.x)) + 1;
    const int high = std::min(size_ - 1, texelAt(grown.high.y)) + 1;
    if (left >= right || low >= high) return;
    ++sumAt(left, low);
    --sumAt(right, low);
    --sumAt(left, high);
    ++sumAt(right, high);
}

bool WantedTexels::anyIn(int x, int y, int side) const {
    return sumAt(x + side, y + side) - sumAt(x, y + side) - sumAt(x + side, y) + sumAt(x, y) > 0;
}

std::uint32_t& WantedTexels::sumAt(int x, int y) {
    return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_ + 1) +
                 static_cast<std::size_t>(x)];
}

std::uint32_t WantedTexels::sumAt(int x, int y) const {
    return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_ + 1) +
                 static_cast<std::size_t>(x)];
}

} // namespace edgeshade
