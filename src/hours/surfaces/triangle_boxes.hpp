#pragma once

#include "preprocess/base/function_ref.hpp"
#include "src/hours/surfaces/world_triangles.hpp"
#include "src/shadow/geometry/box_tree.hpp"

#include <span>

namespace edgeshade::hours {

/// A tree of boxes around triangles, to find those near a point or a ray. Boxes are a little larger
/// than the triangles, against rounding. Thread-safe once made.
class TriangleBoxes {
  public:
    using Use = FunctionRef<void(std::uint32_t triangle)>;

    /// `margin`: distance from triangles within which forPoint() still finds them, 0 or more.
    TriangleBoxes(std::span<const WorldTriangle> triangles, double margin);

    /// Calls use() for all triangles whose boxes hold the point, and perhaps others.
    void forPoint(const glm::dvec3& point, Use use) const;
    /// Calls use() for all triangles whose boxes the ray meets, and perhaps others.
    void forRay(const glm::dvec3& origin, const glm::dvec3& direction, Use use) const;

  private:
    template <class Meets>
    void search(const Meets& meets, Use use) const;

    std::vector<std::uint32_t> triangles_; ///< by item of boxes_
    BoxTree<double> boxes_;
};

} // namespace edgeshade::hours
