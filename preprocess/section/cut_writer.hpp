#pragma once

#include "preprocess/section/cut_origins.hpp"
#include "preprocess/section/geometry_cut.hpp"
#include "preprocess/section/triangle_fates.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// Gives `to` the vertices of a geometry, with all their attributes, and no triangles. `to`: empty,
/// or begun with this before and since then only added to, so that its first vertices are the
/// geometry's already. `more`: vertices that are to follow.
void takeVertices(const Geometry& geometry, std::size_t more, Geometry& to);

/// Writes the triangles of a cut geometry, material by material, with their nodes and origins.
class CutWriter {
  public:
    /// `from`: the geometry before, with the fates of its triangles; `pieces`: of those that planes
    /// met, ascending by source; `placedBy`: the batch's. `to` has the vertices.
    CutWriter(const Geometry& from, const std::vector<TriangleFate>& fates,
              std::span<const CutTriangle> pieces, int placedBy, Geometry& to, CutOrigins& origins);

    /// Adds what is kept, or what is cut away, of a group of `from`, as a group of this material.
    void addPart(const SurfaceGroup& group, std::size_t material, bool away);
    /// Adds those of the pieces that aren't away, of no node, as a group of this material.
    void addFill(std::span<const CutTriangle> fill, std::size_t material);

  private:
    void begin(std::size_t material);
    void end();
    void add(const std::array<std::uint32_t, 3>& corners, std::uint32_t origin);
    /// Adds triangles [first, end) of `from` as they are.
    void addWhole(std::uint32_t first, std::uint32_t end);
    /// Adds the source of a triangle of `from`; returns the end of the triangles that have it too.
    std::uint32_t addSourceOf(std::uint32_t triangle);

    const Geometry& from_;
    const std::vector<TriangleFate>& fates_;
    std::span<const CutTriangle> pieces_;
    int placedBy_;
    Geometry& to_;
    CutOrigins& origins_;
};

} // namespace edgeshade
