#pragma once

#include "src/shadow/geometry/polygon.hpp"
#include "src/shadow/view/frustum.hpp"
#include "src/shadow/view/visible_part.hpp"

#include <array>
#include <cstdint>

namespace edgeshade {

/// A plane in camera space: dot(normal, p) + offset >= 0 inside.
struct Side {
    glm::dvec3 normal;
    double offset;
};

/// The frustum of a picture, widened slightly, against which triangles are clipped.
struct ClippingFrustum {
    explicit ClippingFrustum(const Frustum& given);

    Frustum frustum;
    std::array<Side, 5> sides; ///< the window's four, then the plane through the eye
    glm::dmat4 worldFromView{1.0};
};

/// By how much a GL may place points elsewhere, for slopes.
struct SlopeErrors {
    double nearest = 0.0; ///< no nearer than this, a point may be anywhere in the window
    double offset = 0.0;  ///< error of a coordinate across the viewing direction
};

/// A batch's triangles in a picture: what each adds to the visible geometry.
class BatchInView {
  public:
    /// `farthest`: the largest magnitudes of its positions' coordinates. All references must
    /// outlive it.
    BatchInView(const ClippingFrustum& clipping, const Scene& scene, const Batch& batch,
                const glm::dvec3& farthest);

    /// Extends `part` by a triangle, clipped to the picture, unless the scene certainly culls it.
    /// The result for several triangles doesn't depend on their order.
    void add(std::uint32_t triangle, VisiblePart& part) const;

    const glm::dmat4& viewFromBatch() const { return viewFromBatch_; }
    const SlopeErrors& slopeErrors() const { return slopeErrors_; }
    double error() const { return error_; }
    /// A triangle's corners, in the batch's space.
    std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const {
        const std::uint32_t* const indices = &geometry_.indices[3 * triangle];
        return {geometry_.positions[indices[0]], geometry_.positions[indices[1]],
                geometry_.positions[indices[2]]};
    }

  private:
    bool isSingleSided(std::uint32_t index) const;
    void addSlopes(const glm::dvec3& point, Slopes& slopes) const;

    const ClippingFrustum& clipping_;
    const Scene& scene_;
    const Geometry& geometry_;
    glm::dmat4 viewFromBatch_;
    double error_; ///< bound of a GL's error in placing a corner, in the view
    SlopeErrors slopeErrors_;
    bool mirrored_;
};

/// Bound of a GL's error in placing points in the view. `farthest`: the largest magnitudes of
/// their coordinates.
double placingErrorOf(const glm::dvec3& farthest, const glm::dmat4& viewFromPoints);

/// For points with that placing error.
SlopeErrors slopeErrorsOf(const Frustum& widened, double error);

} // namespace edgeshade
