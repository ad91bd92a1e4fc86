#pragma once

#include "src/render/shadow_map/shadow_map.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Which texels of a sun's map show which places: a lattice of cells over all that casts, whose
/// nodes are moved. A cell is two triangles, cut from its lower to its upper corner, and the warp
/// is affine in each, so that drawing casters cut along the lattice's lines is exact.
///
/// Places are 0..1 across what casts, as ShadowMapView has them, and so are texture coordinates
/// within the map's frame. What is visible lies in the lattice's inner cells, which are all alike;
/// the outermost ones take the rest.
struct MapWarp {
    static constexpr int cells = 32; ///< along an edge of the lattice

    glm::dvec2 low{0.0}, high{1.0};  ///< of the inner cells; within (0, 1)
    bool rectilinear = true;         ///< cells stay rectangles: they are affine as a whole
    double margin = 0.0;             ///< the map's frame, as a share of its width
    std::vector<glm::u16vec2> nodes; ///< (cells + 1)^2, rows of ascending x; 65535ths

    bool operator==(const MapWarp&) const = default;

    /// Where a line of the lattice is, 0..cells.
    glm::dvec2 line(int index) const;
    /// A place in the lattice: whole numbers at its nodes; any number outside of it.
    glm::dvec2 inLattice(const glm::dvec2& place) const;
    /// Where a node is in the texture, with the frame.
    glm::dvec2 node(int x, int y) const;

    /// As shaders_es2/rivals/maps/warp.glsl wants them: the inner cells' low corner and one over
    /// their size; cells per length below and above them.
    glm::dvec4 inner() const;
    glm::dvec4 outer() const;
};

/// A warp that gives places as many texels as are visible there. `visible`: places; those outside
/// of 0..1 are left out. `margin`: MapWarp's.
MapWarp mapWarp(WarpGrid grid, std::span<const glm::dvec2> visible, double margin);

} // namespace edgeshade
