#pragma once

#include "preprocess/base/box.hpp"
#include "src/shadow/lights/light_shape.hpp"
#include "src/shadow/primitive_map/caster_edges.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

/// How a primitive map divides what its light sees.
///
/// Map space is affine to the world and at most 1 large around the casters. Of a directional light
/// x and y are across it and z grows away from it; of a point light the origin is where it is. In
/// both, a *ray* of the light is a homogeneous point (x, y, w) of a tile, which holds those with
/// |x| <= w and |y| <= w: a directional light's ray to a point of map space is (x, y, 1), its depth
/// z; a point light's is the point itself in the tile's axes, whose depth is its w.
struct LightTiles {
    bool directional = true;
    glm::dmat4 mapFromWorld{1.0};
    /// Rows are a tile's x, y and w axes in map space: one tile (the identity), or six in the order
    /// of +x, -x, +y, -y, +z, -z around a point light among the casters.
    std::vector<glm::dmat3> tiles;
    /// How far the casters' depths span, as a share of the farthest one: floats tell depths apart
    /// by that much less.
    double depthSpan = 1.0;
    /// All of the light, in map space; nothing: it has no extent, and rays end in its middle.
    std::optional<LightShape> shape;
    /// Of a directional light with an extent: the depth of the farthest point that it shines on.
    double farthestReceiver = 0.0;

    /// The tile's ray to a point of map space.
    glm::dvec3 rayTo(std::size_t tile, const glm::dvec3& point) const {
        return directional ? glm::dvec3(point.x, point.y, 1.0) : point * tiles[tile];
    }
};

/// Fitted to the casters as closely as they allow: for a point light outside of them one tile, if
/// they lie within some 60 degrees of its middle. No point that is outside of all tiles has a
/// caster between itself and any of the light's places. Nothing where nothing casts. `receivers`:
/// all that the light shines on, in the world; of directional lights with an extent.
std::optional<LightTiles> tilesFor(const Light& light, const std::vector<PlacedCasters>& casters,
                                   const Box& receivers = {});

/// Point lights whose casters span less of their depths are too far off: rounding would join what
/// touches not quite.
inline constexpr double leastDepthSpan = 0.125;

/// Within a tile's square, how far rounding in a GL may place a ray: map coordinates and their
/// interpolation, some tens of units of 2^-24 of 1.
inline constexpr double mapRounding = 32.0 / (1 << 24);

} // namespace edgeshade
