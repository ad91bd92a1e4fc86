#pragma once

#include "preprocess/base/box.hpp"
#include "src/shadow/lights/light_shape.hpp"
#include "src/shadow/primitive_map/caster_edges.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

/// How a primitive map divides its light's view into tiles.
///
/// Map space is affine to the world and at most 1 large around the casters. For a directional light
/// x and y are across it and z grows away from it; for a point light the origin is at the light. A
/// *ray* of the light is a homogeneous point (x, y, w) of a tile, which holds those with |x| <= w
/// and |y| <= w. A directional light's ray to a point of map space is (x, y, 1), and its depth is
/// z. A point light's ray is the point itself in the tile's axes, and its depth is its w.
struct LightTiles {
    bool directional = true;
    glm::dmat4 mapFromWorld{1.0};
    /// The rows of each matrix are a tile's x, y and w axes in map space. There is one tile (the
    /// identity), or six in the order of +x, -x, +y, -y, +z, -z around a point light among the
    /// casters.
    std::vector<glm::dmat3> tiles;
    /// Range of the casters' depths as a share of the farthest one: floats resolve depths less
    /// finely by that factor.
    double depthSpan = 1.0;
    /// The whole light in map space; null: it has no extent, and rays end in its middle.
    std::optional<LightShape> shape;
    /// For a directional light with an extent, the depth of the farthest point it shines on.
    double farthestReceiver = 0.0;

    /// The tile's ray to a point of map space.
    glm::dvec3 rayTo(std::size_t tile, const glm::dvec3& point) const {
        return directional ? glm::dvec3(point.x, point.y, 1.0) : point * tiles[tile];
    }
};

/// Fits tiles to the casters as closely as possible: one tile for a point light outside them, if
/// they lie within about 60 degrees of its middle. No point outside all tiles has a caster between
/// itself and any point of the light. Null if nothing casts. `receivers`: everything that the light
/// shines on, in the world; used for directional lights with an extent.
std::optional<LightTiles> tilesFor(const Light& light, const std::vector<PlacedCasters>& casters,
                                   const Box& receivers = {});

/// Smallest depthSpan for a point light. Below it the light is too far away: rounding would merge
/// surfaces that almost touch.
inline constexpr double leastDepthSpan = 0.125;

/// Rounding error of a ray in a GL, within a tile's square, from map coordinates and their
/// interpolation: a few tens of units of 2^-24 of 1.
inline constexpr double mapRounding = 32.0 / (1 << 24);

} // namespace edgeshade
