#pragma once

#include "src/rays/box_tree.hpp"
#include "src/rays/surface_point.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::rays {

/// A tree of boxes around triangles. It finds every triangle that a ray meets, taken as the
/// doubles that both are, and some that it misses (docs/method.md, C56). Thread-safe once built.
class RayTree {
  public:
    /// `corners`: of all triangles; `which`: the indices of those to find. Triangles whose corners
    /// aren't all finite are never found.
    RayTree(std::span<const Corners> corners, std::vector<std::uint32_t> which);

    /// Calls visit(triangle) for all triangles that origin + t * direction may meet at t from 0 to
    /// `length`, in any order, until it returns true. A direction of 0 meets none.
    void visit(const glm::dvec3& origin, const glm::dvec3& direction, double length,
               const std::function<bool(std::uint32_t)>& visit) const;

    /// Calls visit(triangle) for all triangles that origin + t * direction may meet at t from 0 to
    /// the least value that visit() has returned so far, near ones first, more or less.
    void visitInOrder(const glm::dvec3& origin, const glm::dvec3& direction,
                      const std::function<double(std::uint32_t)>& visit) const;

    /// Where rays start, in the tree's own coordinates.
    struct Origins : BoxTree::Origins {
        bool inside =
            true; ///< all are within the tree's box or close to it; else they need visit()
    };
    /// `places`: at most packetSize.
    Origins originsOf(std::span<const glm::dvec3> places) const;

    /// Tests a triangle; returns the rays whose search is over.
    using Test = BoxTree::Test;

    /// Calls test(state, triangle) for all triangles that rays in one direction, not 0, may meet at
    /// t >= 0, until the search of all of them is over. `rays`: those of the packet that search.
    void visitPacket(const Origins& origins, const glm::dvec3& direction, Lanes rays, Test test,
                     void* state) const;

  private:
    struct Line;

    /// The tree's coordinates: (p - center) * scale, at most 1 within it.
    struct Space {
        glm::dvec3 center{0.0};
        double scale = 1.0; ///< a power of two

        /// The space of some of the triangles.
        Space(std::span<const Corners> corners, std::span<const std::uint32_t> which);

        glm::dvec3 local(const glm::dvec3& place) const { return (place - center) * scale; }
    };

    /// Null: the line meets no triangle.
    std::optional<Line> lineOf(const glm::dvec3& origin, const glm::dvec3& direction) const;

    Space space_;
    BoxTree boxes_;
};

} // namespace edgeshade::rays
