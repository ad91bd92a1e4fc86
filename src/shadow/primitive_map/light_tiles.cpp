#include "src/shadow/primitive_map/light_tiles.hpp"

#include "src/shadow/geometry/vectors.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Margin around the casters, as a share of their extent: rounding must not place rays at the rim
/// outside.
constexpr double frame = 1e-3;

/// The steepest rays, as tangents, that one tile covers.
constexpr double steepest = 1.8;

template <class Use>
void forEachVertex(const std::vector<PlacedCasters>& casters, Use use) {
    for (const PlacedCasters& placed : casters)
        if (placed.cast)
            for (const glm::vec3& position : placed.casters->mesh.positions)
                use(glm::dvec3(placed.worldFromBatch * glm::dvec4(glm::dvec3(position), 1.0)));
}

/// The largest coordinate of a box along an axis.
double farthestAlong(const glm::dvec3& axis, const Box& box) {
    return glm::dot(glm::max(axis * box.low, axis * box.high), glm::dvec3(1.0));
}

LightTiles parallelTile(const Light& light, const std::vector<PlacedCasters>& casters,
                        const Box& receivers) {
    const auto axes = axesAlong(-unitOf(glm::dvec3(light.position)));
    Box box;
    forEachVertex(casters, [&](const glm::dvec3& p) {
        box.add({glm::dot(axes[0], p), glm::dot(axes[1], p), glm::dot(axes[2], p)});
    });
    const glm::dvec3 center = box.center();
    glm::dvec3 half = 0.5 * (box.high - box.low) * (1.0 + frame);
    half = glm::max(half, glm::dvec3(std::max(1e-6 * box.diagonal(), 1e-300)));
    LightTiles result;
    if (light.extent) {
        double farthest = box.high.z;
        if (!receivers.empty()) farthest = std::max(farthest, farthestAlong(axes[2], receivers));
        result.farthestReceiver = (farthest - center.z) / half.z * (1.0 + frame) + frame;
        // The range over which the casters' shadows spread.
        const double spread =
            std::tan(light.extent->radius) * half.z * (result.farthestReceiver + 1.0);
        half.x += spread * (1.0 + frame);
        half.y += spread * (1.0 + frame);
    }
    std::array<glm::dvec4, 3> rows;
    for (glm::length_t i = 0; i < 3; ++i)
        rows[static_cast<std::size_t>(i)] =
            glm::dvec4(axes[static_cast<std::size_t>(i)], -center[i]) / half[i];
    result.mapFromWorld = fromRows(rows[0], rows[1], rows[2]);
    result.tiles = {glm::dmat3(1.0)};
    return result;
}

/// A tile that holds all casters in front of the light; null if they don't fit one.
std::optional<LightTiles> fittedTile(const LightShape& shape, const Box& bounds,
                                     const std::vector<PlacedCasters>& casters) {
    const glm::dvec3 light(shape.center);
    const glm::dvec3 offset = bounds.center() - light;
    if (!(glm::length(offset) > 0.0)) return std::nullopt;
    const auto axes = axesAlong(unitOf(offset));
    glm::dvec2 low(INFINITY), high(-INFINITY);
    double nearest = INFINITY, farthest = 0.0;
    forEachVertex(casters, [&](const glm::dvec3& p) {
        const glm::dvec3 d = p - light;
        const double w = glm::dot(axes[2], d);
        const glm::dvec2 at = glm::dvec2(glm::dot(axes[0], d), glm::dot(axes[1], d)) / w;
        nearest = std::min(nearest, w);
        farthest = std::max(farthest, w);
        low = glm::min(low, at);
        high = glm::max(high, at);
    });
    const glm::dvec2 reach = glm::max(glm::abs(low), glm::abs(high));
    if (!(nearest > 0.0) || !(std::max(reach.x, reach.y) < steepest)) return std::nullopt;
    const glm::dvec2 middle = 0.5 * (low + high);
    glm::dvec2 half =
        glm::max(0.5 * (high - low) * (1.0 + frame), glm::dvec2(1e-6 * (reach.x + reach.y)));
    for (glm::length_t i = 0; i < 2; ++i) { // the range over which the casters' shadows spread
        const glm::dvec3 across =
            (axes[static_cast<std::size_t>(i)] - middle[i] * axes[2]) / half[i];
        const double spread =
            std::max({shape.support(across - axes[2]), shape.support(across + axes[2]),
                      2.0 * shape.support(axes[2])}) /
            nearest;
        if (spread > 0.5) return std::nullopt;
        half[i] /= 1.0 - spread;
    }
    LightTiles result;
    result.directional = false;
    result.depthSpan = (farthest - nearest) / farthest;
    std::array<glm::dvec4, 3> rows;
    for (glm::length_t i = 0; i < 2; ++i) {
        const glm::dvec3 axis = (axes[static_cast<std::size_t>(i)] - middle[i] * axes[2]) / half[i];
        rows[static_cast<std::size_t>(i)] = glm::dvec4(axis, -glm::dot(axis, light)) / farthest;
    }
    rows[2] = glm::dvec4(axes[2], -glm::dot(axes[2], light)) / farthest;
    result.mapFromWorld = fromRows(rows[0], rows[1], rows[2]);
    result.tiles = {glm::dmat3(1.0)};
    return result;
}

LightTiles sixTiles(const glm::dvec3& light, const std::vector<PlacedCasters>& casters) {
    double farthest = 0.0;
    forEachVertex(casters, [&](const glm::dvec3& p) {
        const glm::dvec3 d = glm::abs(p - light);
        farthest = std::max({farthest, d.x, d.y, d.z});
    });
    LightTiles result;
    result.directional = false;
    const double scale = farthest > 0.0 ? 1.0 / farthest : 1.0;
    result.mapFromWorld = fromRows({scale, 0, 0, -scale * light.x}, {0, scale, 0, -scale * light.y},
                                   {0, 0, scale, -scale * light.z});
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dmat3 tile(0.0); // glm's columns hold the tile's rows, for `point * tile`
            tile[0][(axis + 1) % 3] = 1.0;
            tile[1][(axis + 2) % 3] = 1.0;
            tile[2][axis] = sign;
            result.tiles.push_back(tile);
        }
    return result;
}

} // namespace

std::optional<LightTiles> tilesFor(const Light& light, const std::vector<PlacedCasters>& casters,
                                   const Box& receivers) {
    Box bounds;
    forEachVertex(casters, [&](const glm::dvec3& p) { bounds.add(p); });
    if (bounds.empty()) return std::nullopt;
    LightShape shape = shapeOf(light);
    LightTiles tiles;
    if (light.position.w == 0.0) {
        tiles = parallelTile(light, casters, receivers);
    } else {
        shape.center = light.position / light.position.w;
        const auto fitted = fittedTile(shape, bounds, casters);
        tiles = fitted ? *fitted : sixTiles(glm::dvec3(shape.center), casters);
    }
    if (light.extent) tiles.shape = shape.in(tiles.mapFromWorld);
    return tiles;
}

} // namespace edgeshade
