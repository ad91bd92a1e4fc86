#pragma once

#include "preprocess/base/parallel.hpp"
#include "src/rays/holes.hpp"
#include "src/rays/lit_bits.hpp"
#include "src/rays/surface_set.hpp"
#include "src/rays/surface_triangles.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace edgeshade::rays {

/// Decides by rays which points are lit, as docs/method.md, C30, defines it. Embree finds the
/// triangles that may block a ray; doubles with a bound on their error decide; where the bound
/// leaves a doubt, integers decide without rounding. So every answer is that of exact geometry,
/// with triangles, points and directions taken as the doubles that they are (docs/method.md, C56).
///
///     const rays::LitRays litRays(scene, rays::surfaceTriangles(scene, origin, false, false));
///     std::vector<rays::SurfacePoint> points;
///     points.push_back(rays::SurfacePoint::at(position - origin, normal, triangle));
///     const rays::LitBits lit = litRays.lit(points, directions);
///     lit.at(point, direction); lit.count(point);
///
/// Build it once for a scene. Thread-safe once built.
class LitRays {
  public:
    /// `triangles`: of `scene`, which must outlive this, relative to any one point of the world,
    /// from surfaceTriangles(). Those with `casts` block light. `isHole`: null: casters have no
    /// holes.
    LitRays(const Scene& scene, std::vector<SurfaceTriangle> triangles, IsHole isHole = {});
    /// The same for a set that others use too.
    LitRays(const Scene& scene, std::shared_ptr<const SurfaceSet> surfaces, IsHole isHole = {});

    /// Whether a directional light in each of `directions` lights each of `points`, on all threads.
    /// A direction points towards the light, in world axes, and has any length but 0. A point is
    /// relative to the same place as the triangles, and names its triangle by index. It is dark
    /// - if the triangle casts and is looked at from one side and lit from the other; a point of no
    ///   triangle, if light comes from where its line of sight goes;
    /// - if the light grazes the triangle (docs/method.md, C47);
    /// - if a caster other than its triangle blocks the light; none in the triangle's plane can.
    ///
    /// Neighbours in `points` share packets of sixteen rays, and neighbours in `directions` are
    /// likely to be blocked by the same triangle: lists in which neighbours are close together are
    /// quickest. `progress` receives the share done, from the caller's thread alone; it may be
    /// null.
    LitBits lit(std::span<const SurfacePoint> points, std::span<const glm::dvec3> directions,
                Threads threads = {}, const std::function<void(double)>& progress = {}) const;

    const std::vector<SurfaceTriangle>& triangles() const { return surfaces_->triangles; }

  private:
    const Scene* scene_;
    std::shared_ptr<const SurfaceSet> surfaces_;
    Holes holes_;
};

} // namespace edgeshade::rays
