#include "src/shadow/primitive_map/wanted_texels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeshade {
namespace {

constexpr int mostCells = 64; ///< along a tile's edge

/// A rectangle of rays that holds all of the tile's to the triangle. It may be the whole tile where
/// a corner is behind the light. Null: there are none.
std::optional<RaySquare> raysTo(const WorldTriangle& triangle, const LightTiles& tiles,
                                std::size_t tile) {
    constexpr double grown = 1.0 + 1e-3; // the tile's pyramid
    RaySquare rays{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
    glm::dvec2 least = rays.low, most = rays.high; // of coordinates beyond the tile's sides
    bool inFront = true;
    for (const glm::dvec3& corner : triangle) {
        const glm::dvec3 map(tiles.mapFromWorld * glm::dvec4(corner, 1.0));
        const glm::dvec3 ray = tiles.rayTo(tile, map);
        const glm::dvec2 at(ray);
        least = glm::min(least, at - grown * ray.z);
        most = glm::max(most, at + grown * ray.z);
        inFront = inFront && ray.z > 0.0;
        rays.low = glm::min(rays.low, at / ray.z);
        rays.high = glm::max(rays.high, at / ray.z);
    }
    if (inFront) return rays;
    if (std::max(least.x, least.y) > 0.0 || std::min(most.x, most.y) < 0.0) return std::nullopt;
    return RaySquare{glm::dvec2(-1.0), glm::dvec2(1.0)};
}

} // namespace

WantedTexels::WantedTexels(const LightTiles& tiles, std::size_t tile, int size,
                           std::span<const WorldTriangle> triangles)
    : cells_(std::min(size, mostCells)), cellSide_(size / cells_),
      wanted_(static_cast<std::size_t>(cells_ * cells_)) {
    const auto cellAt = [&](double at) {
        return static_cast<int>(
            std::clamp(std::floor((at + 1.0) * 0.5 * cells_), -1.0, static_cast<double>(cells_)));
    };
    for (const WorldTriangle& triangle : triangles) {
        const auto rays = raysTo(triangle, tiles, tile);
        if (!rays) continue;
        const RaySquare grown = rays->grownBy(2.0 * mapRounding);
        const int left = std::max(0, cellAt(grown.low.x));
        const int right = std::min(cells_ - 1, cellAt(grown.high.x));
        const int high = std::min(cells_ - 1, cellAt(grown.high.y));
        for (int y = std::max(0, cellAt(grown.low.y)); y <= high; ++y)
            for (int x = left; x <= right; ++x)
                wanted_[static_cast<std::size_t>(y * cells_ + x)] = 1;
    }
}

bool WantedTexels::anyIn(int x, int y, int side) const {
    const int right = (x + side - 1) / cellSide_, high = (y + side - 1) / cellSide_;
    for (int row = y / cellSide_; row <= high; ++row)
        for (int column = x / cellSide_; column <= right; ++column)
            if (wanted_[static_cast<std::size_t>(row * cells_ + column)] != 0) return true;
    return false;
}

} // namespace edgeshade
