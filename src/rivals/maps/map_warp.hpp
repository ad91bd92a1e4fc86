#pragma once

#include "src/render/shadow_map/shadow_map.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Warps a sun's map to give some places more texels: moves the nodes of a lattice of cells over
/// all casters. A cell is two triangles, split from its lower to its upper corner, and the warp is
/// affine in each. So drawing casters that are cut along the lattice's lines is exact.
///
/// Places are 0..1 across all casters, as in ShadowMapView, and so are texture coordinates within
/// the map's frame. Visible geometry is in the lattice's inner cells, which are all alike; the
/// outermost cells take the rest.
struct MapWarp {
    static constexpr int cells = 32; ///< along an edge of the lattice

    glm::dvec2 low{0.0}, high{1.0};  ///< bounds of the inner cells, within (0, 1)
    bool rectilinear = true;         ///< cells stay rectangles: each is affine as a whole
    double margin = 0.0;             ///< the map's frame, as a share of its width
    std::vector<glm::u16vec2> nodes; ///< (cells + 1)^2 nodes, in rows of ascending x; in units of
                                     ///< 1/65535

    bool operator==(const MapWarp&) const = default;

    /// Position of a line of the lattice, 0..cells.
    glm::dvec2 line(int index) const;
    /// Lattice coordinates of a place: whole numbers at nodes; not clamped outside the lattice.
    glm::dvec2 inLattice(const glm::dvec2& place) const;
    /// A node's texture coordinates, including the frame.
    glm::dvec2 node(int x, int y) const;

    /// Uniforms of shaders_es2/rivals/maps/warp.glsl: the inner cells' low corner and one over
    /// their size; cells per length below and above them.
    glm::dvec4 inner() const;
    glm::dvec4 outer() const;
};

/// Computes a warp that gives places texels in proportion to what is visible there. `visible`:
/// places; those outside 0..1 are ignored. `margin`: MapWarp::margin.
MapWarp mapWarp(WarpGrid grid, std::span<const glm::dvec2> visible, double margin);

} // namespace edgeshade
