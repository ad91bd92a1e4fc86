#pragma once

#include "preprocess/base/parallel.hpp"
#include "preprocess/section/cut_origins.hpp"
#include "src/shadow/geometry/box_tree.hpp"
#include "src/shadow/geometry/normal_cone.hpp"

#include <span>

namespace edgeshade {

/// Whether a tree has cones of normals: scenes that cull nothing need none.
enum class Cones : std::uint8_t { none, found };

/// Boxes around the visible triangles of a geometry, in leaves of at most eight neighbours, and
/// perhaps cones of their normals. Takes 13 bytes a triangle. It holds no positions, so that it is
/// right only for the geometry, and the sides of its materials, that it was made from or refitted
/// to.
class TriangleTree {
  public:
    static constexpr std::size_t leafSize = 8;

    TriangleTree() = default; ///< no triangles
    /// Takes a time that grows a little more than linearly with the triangles.
    /// `materials`: the scene's.
    TriangleTree(const Geometry& geometry, const std::vector<Material>& materials,
                 Cones cones = Cones::found, Threads threads = {});
    /// A cut's tree, without cones. `whole`: the tree of `origins.from`; leaves that keep all their
    /// triangles keep their boxes, those that keep none are dropped. Pieces and fills get leaves of
    /// their own. `materials`: of the cut scene. Takes a time that is linear in the triangles, and
    /// small except for pieces.
    TriangleTree(const TriangleTree& whole, const Geometry& cut, const CutOrigins& origins,
                 const std::vector<Material>& materials);

    /// Fits boxes and cones to other positions of the same triangles.
    void refit(const Geometry& geometry, const std::vector<Material>& materials);

    const BoxTree<float>& boxes() const { return boxes_; }
    bool hasCones() const { return !cones_.empty(); }
    /// The normals in the boxes of that group, if it hasCones(); known where all triangles are
    /// single-sided.
    const FourCones& cones(std::size_t level, std::size_t group) const {
        return cones_[boxes_.numberOf(level, group)];
    }
    /// Numbers of a leaf's triangles; triangle t has the corners indices[3 t] to indices[3 t + 2].
    std::span<const std::uint32_t> trianglesOf(std::size_t leaf) const {
        return std::span(triangles_).subspan(firsts_[leaf], firsts_[leaf + 1] - firsts_[leaf]);
    }
    std::size_t size() const { return triangles_.size(); } ///< number of triangles
    const Box& bounds() const { return bounds_; }          ///< of the triangles' corners
    /// The largest magnitude of each coordinate of all positions.
    const glm::dvec3& farthest() const { return farthest_; }

  private:
    void addLeaves(std::size_t first);
    std::vector<std::uint32_t> takeLeaves(const TriangleTree& whole,
                                          const std::vector<std::uint32_t>& keptAs);
    void fitLeaf(std::size_t leaf, const Geometry& geometry);
    void fitAround(const Geometry& geometry, std::size_t firstPosition);
    void fitCones(const Geometry& geometry, const std::vector<Material>& materials);
    void fitCone(std::size_t level, std::size_t i);

    std::vector<std::uint32_t> triangles_; ///< leaf by leaf
    std::vector<std::uint32_t> firsts_;    ///< by leaf, its first in triangles_; then their end
    BoxTree<float> boxes_;                 ///< of the leaves
    std::vector<FourCones> cones_;         ///< by group of boxes_; or empty
    Box bounds_;
    glm::dvec3 farthest_{0.0};
};

} // namespace edgeshade
