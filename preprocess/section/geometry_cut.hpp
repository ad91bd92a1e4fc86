#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// One of a geometry's triangles, or a piece of one.
struct CutTriangle {
    std::array<std::uint32_t, 3> corners{}; ///< vertices of the geometry, in the triangle's winding
    std::uint32_t source = 0;               ///< number of the triangle that it was
    bool solid = false;                     ///< of a closed surface, or closes a cut
    bool away = false;                      ///< some plane cuts it away
};

/// The line in which a plane cuts a solid's triangle, between two vertices of the geometry.
/// Directed as the kept piece's border runs, so that a face which closes the cut runs against it.
struct CutLine {
    std::uint32_t from = 0, to = 0;
};

/// Cuts a geometry's triangles along planes, one after the other (docs/method.md, C49).
///
/// Neighbours agree bit for bit: which side a vertex is on depends on its position alone, and where
/// an edge is cut on its two end points alone, starting at the one that is kept.
class GeometryCut {
  public:
    /// Starts with the triangles that `indices` lists, three corners each; none is solid. New
    /// vertices are added to `geometry`, with attributes between those of an edge's ends; it must
    /// outlive this.
    GeometryCut(Geometry& geometry, const std::vector<std::uint32_t>& indices);
    /// Starts with some of them: `triangles`, ascending. `solid`: by triangle of `indices`.
    GeometryCut(Geometry& geometry, const std::vector<std::uint32_t>& indices,
                const std::vector<std::uint8_t>& solid,
                const std::vector<std::uint32_t>& triangles);

    /// Cuts by a plane in the geometry's space. `keepsAway`: pieces that are cut away stay, with
    /// `away` set, and later planes cut them too, so that neighbours still fit; otherwise they go.
    /// A triangle in the plane is kept, unless it bounds a solid that is cut away.
    /// Returns the lines of all solid triangles that weren't away before.
    std::vector<CutLine> cut(const glm::dvec4& plane, bool keepsAway);

    /// Adds a triangle that closes a cut.
    void add(const CutTriangle& triangle) { triangles_.push_back(triangle); }

    const std::vector<CutTriangle>& triangles() const { return triangles_; }

  private:
    Geometry& geometry_;
    std::vector<CutTriangle> triangles_;
};

/// The plane in a batch's space.
glm::dvec4 planeInBatch(const glm::dvec4& plane, const glm::dmat4& worldFromBatch);

/// The sides of a box that planes can leave it on.
enum class BoxSide { kept, crossed, away };

/// Where a box lies: kept by all planes, cut away by one, or neither. A plane that touches the box
/// counts as crossing it.
BoxSide sideOf(const Box& box, const std::vector<glm::dvec4>& planes);

} // namespace edgeshade
