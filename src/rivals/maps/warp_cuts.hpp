#pragma once

#include "src/rivals/maps/map_warp.hpp"
#include "src/shadow/geometry/polygon.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// A corner of a caster's piece.
struct WarpedCorner {
    glm::dvec3 weights; ///< weights of the caster's corners; their sum is 1
    glm::dvec3 place;   ///< texture coordinates, and the distance from the light
};

/// Cuts casters into pieces within which a warp is affine, so that the GL, which draws straight
/// edges, draws them exactly. Neighbours are cut at the same points. Rosen (2012) tessellates to
/// approximate this; cuts along the warp's own lines leave no error.
class WarpCuts {
  public:
    explicit WarpCuts(const MapWarp& warp);

    /// `corners`: in map space (ShadowMapView). Appends pieces to `to`, three corners each.
    void add(const std::array<glm::dvec3, 3>& corners, std::vector<WarpedCorner>& to) const;

  private:
    /// The warp of half a cell: maps a place to texture coordinates.
    struct Affine {
        glm::dvec2 atX, atY, offset;

        glm::dvec2 of(const glm::dvec3& place) const {
            return atX * place.x + atY * place.y + offset;
        }
    };
    struct Cut;
    glm::dvec3 inLattice(const glm::dvec3& along, glm::length_t axis) const;
    glm::ivec2 rowsOf(const Polygon& part, const glm::dvec3& y) const;
    void addCell(const Polygon& part, const glm::ivec2& cell, const Cut& cut) const;
    const Affine& affine(int x, int y, bool upper) const {
        return affines_[static_cast<std::size_t>(2 * (y * MapWarp::cells + x) + upper)];
    }

    MapWarp warp_;
    std::vector<Affine> affines_; ///< by cell: below its diagonal, above it
};

} // namespace edgeshade
