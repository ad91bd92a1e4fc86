#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/primitive_map/light_tiles.hpp"
#include "src/shadow/primitive_map/ray_square.hpp"

#include <array>
#include <cstdint>

namespace edgeshade {

/// A casting triangle in map space (LightTiles), with the planes that decide which rays meet it,
/// and which points are behind it.
struct Occluder {
    /// The triangle's edges as planes through the light: rays with dot(edge, ray) >= 0 for all
    /// three meet it. Each is computed in double precision from the edge's ends in their order A <
    /// B, and negated for the triangle on the other side, so that neighbours agree to the last bit.
    std::array<glm::dvec3, 3> edges;
    /// Whether each edge was not negated: then rays on the edge belong to this triangle, and are
    /// counted once.
    std::array<bool, 3> takesEdge{};
    /// For a directional light, a point p of map space is behind the plane if p.z > dot(plane,
    /// (p.x, p.y, 1)); for a point light, if dot(plane, p) > 1.
    glm::dvec3 plane{0.0};
    std::array<glm::dvec3, 3> corners; ///< in map space, in winding order; edge i runs from i to i
                                       ///< + 1
    std::uint8_t contours = 0;         ///< bit i: edge i is a contour
    bool lightFacing = true;
    /// For a light with an extent: parts of it are on both sides of the plane.
    bool mixed = false;
    /// For a light with an extent: its middle is almost in the plane, and `edges` and `plane` are
    /// unknown.
    bool flat = false;
    static constexpr std::uint32_t solid = ~std::uint32_t{0};
    std::uint32_t triangle = 0;   ///< in its casters' mesh
    bool blocks = true;           ///< rays that meet it count as blocked
    std::uint32_t cutout = solid; ///< index of its alpha in Occluders::cutouts

    bool isSolid() const { return cutout == solid; }
};

/// Casting triangles.
struct Occluders {
    std::vector<Occluder> all;
    std::vector<CutoutPlanes> cutouts; ///< for alpha-tested triangles
};

/// The casting triangles of all batches. For a light without an extent it omits those beyond its
/// range and those whose plane it is in.
Occluders occludersOf(const Light& light, const LightTiles& tiles,
                      const std::vector<PlacedCasters>& casters);

/// The side of a triangle that a homogeneous light is on, all in one object's space: 1 if it sees
/// the triangle counter-clockwise, -1 if clockwise. Exactly 0 means that it is in the plane.
int lightSideOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light);

/// An occluder in one tile.
struct Footprint {
    std::uint32_t occluder = 0;
    std::array<glm::dvec3, 3> edges; ///< Occluder::edges in the tile's axes
    glm::dvec3 plane{0.0};           ///< Occluder::plane in the tile's axes
    glm::dvec2 low, high;            ///< a box around its rays (x, y, 1)
    Interval depths;                 ///< of its points in the tile
    std::array<glm::dvec2, 3> ends;  ///< its corners' rays, if endsKnown
    bool endsKnown = false;          ///< all corners are in front of the light
    bool flat = false;               ///< Occluder::flat
    /// It is so near to a light with an extent that any segment to the light may meet it
    /// (TileSpread).
    bool nearLight = false;

    /// Whether it may have rays in the square; false is certain.
    bool mayTouch(const RaySquare& square) const;
    /// Whether edge i may pass through the square; false is certain.
    bool mayCross(int i, const RaySquare& square) const;
    /// Whether the ray meets it; a ray on an edge belongs to one of the two neighbours. Null near a
    /// corner, where more than two meet.
    std::optional<bool> covers(const glm::dvec3& ray, const Occluder& of) const;
    /// Bounds of the depths of its points on the square's rays.
    Interval depthsIn(const RaySquare& square, bool directional) const;
};

/// The occluder's footprint in a tile. Null if it has no ray in the tile, and meets no segment from
/// there to a light with an extent.
std::optional<Footprint> footprintOf(const Occluder& occluder, std::uint32_t index,
                                     const LightTiles& tiles, std::size_t tile);

} // namespace edgeshade
