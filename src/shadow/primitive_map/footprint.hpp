#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/primitive_map/light_tiles.hpp"
#include "src/shadow/primitive_map/ray_square.hpp"

#include <array>
#include <cstdint>

namespace edgeshade {

/// A triangle that casts, in map space (LightTiles): what tells rays that meet it from others, and
/// points behind it from those before it.
struct Occluder {
    /// The triangle's edges as planes through the light: rays with dot(edge, ray) >= 0 for all
    /// three meet it. Each is computed in double from the edge's ends in their order A < B, and
    /// negated for the triangle on the other side: neighbours agree to the last bit.
    std::array<glm::dvec3, 3> edges;
    /// Which of them were not negated: these take what lies on the edge where it is counted once.
    std::array<bool, 3> takesEdge{};
    /// Of a directional light: a point p of map space is behind the plane where p.z > dot(plane,
    /// (p.x, p.y, 1)); of a point light where dot(plane, p) > 1.
    glm::dvec3 plane{0.0};
    std::array<glm::dvec3, 3> corners; ///< in map space, as wound; edge i runs from i to i + 1
    std::uint8_t contours = 0;         ///< bit i: casters don't go on alike across edge i
    bool lightFacing = true;
    /// Of a light with an extent: not all of it is on one side of the plane.
    bool mixed = false;
    /// Likewise: its middle all but lies in the plane, and neither `edges` nor `plane` are known.
    bool flat = false;
    static constexpr std::uint32_t solid = ~std::uint32_t{0};
    std::uint32_t triangle = 0;   ///< of its casters' mesh
    bool blocks = true;           ///< rays that meet it count as blocked
    std::uint32_t cutout = solid; ///< where its alpha is, in Occluders::cutouts

    bool isSolid() const { return cutout == solid; }
};

/// Casting triangles.
struct Occluders {
    std::vector<Occluder> all;
    std::vector<CutoutPlanes> cutouts; ///< of those that are alpha-tested
};

/// The casting triangles of all batches: those within its range that the light is not in the plane
/// of; of a light with an extent all.
Occluders occludersOf(const Light& light, const LightTiles& tiles,
                      const std::vector<PlacedCasters>& casters);

/// Which side of a triangle a homogeneous light is on, all in one object's space: 1 where it sees
/// it counter-clockwise. Exactly 0 is "in its plane".
int lightSideOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light);

/// An occluder as one tile has it.
struct Footprint {
    std::uint32_t occluder = 0;
    std::array<glm::dvec3, 3> edges; ///< Occluder's in the tile's axes
    glm::dvec3 plane{0.0};           ///< likewise
    glm::dvec2 low, high;            ///< a box around its rays (x, y, 1)
    Interval depths;                 ///< of its points in the tile
    std::array<glm::dvec2, 3> ends;  ///< its corners' rays, where endsKnown
    bool endsKnown = false;          ///< all corners are before the light
    bool flat = false;               ///< Occluder's
    /// So near to a light with an extent that any segment to it may meet it (TileSpread).
    bool nearLight = false;

    /// Whether it may have rays in the square; false is certain.
    bool mayTouch(const RaySquare& square) const;
    /// Whether edge i may pass through the square; false is certain.
    bool mayCross(int i, const RaySquare& square) const;
    /// Whether it has the ray; what lies on an edge belongs to one of two neighbours. Nothing next
    /// to a corner, where more than two meet.
    std::optional<bool> covers(const glm::dvec3& ray, const Occluder& of) const;
    /// Depths of its points on the square's rays, none left out.
    Interval depthsIn(const RaySquare& square, bool directional) const;
};

/// Nothing where the occluder has no ray in the tile, nor meets a segment of one to a light with an
/// extent.
std::optional<Footprint> footprintOf(const Occluder& occluder, std::uint32_t index,
                                     const LightTiles& tiles, std::size_t tile);

} // namespace edgeshade
