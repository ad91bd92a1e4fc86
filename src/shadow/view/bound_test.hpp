#pragma once

#include "src/shadow/geometry/box_tree.hpp"
#include "src/shadow/view/batch_in_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade {

/// One of the numbers of a VisiblePart.
struct PartBound {
    enum class Of { depth, right, up, x, y, z };
    Of of = Of::depth;
    bool high = false; ///< the high end, otherwise the low one

    double in(const VisiblePart& part) const;
};

/// All of them, the nearest depth first.
inline constexpr std::array<PartBound, 12> partBounds = {{
    {PartBound::Of::depth, false},
    {PartBound::Of::depth, true},
    {PartBound::Of::right, false},
    {PartBound::Of::right, true},
    {PartBound::Of::up, false},
    {PartBound::Of::up, true},
    {PartBound::Of::x, false},
    {PartBound::Of::x, true},
    {PartBound::Of::y, false},
    {PartBound::Of::y, true},
    {PartBound::Of::z, false},
    {PartBound::Of::z, true},
}};

/// A linear function of places in a space, dot(plane, (p, 1)), with a limit of the sums of its
/// terms' magnitudes.
struct LinearBound {
    glm::dvec4 plane{0.0};
    double terms = 0.0;
};

/// Camera and world coordinates of points, as functions of their places in another space.
class SpaceInView {
  public:
    /// `farthest`: the largest magnitudes of coordinates there. The reference must outlive it.
    SpaceInView(const ClippingFrustum& clipping, const glm::dmat4& viewFromSpace,
                const glm::dvec3& farthest, const SlopeErrors& errors);

    const LinearBound& view(glm::length_t axis) const { return view_[axis]; }
    LinearBound world(glm::length_t axis) const;
    /// Negative where surfaces are certainly outside that side of the frustum.
    const glm::dvec4& side(std::size_t i) const { return sides_[i]; }
    const Frustum& frustum() const { return clipping_.frustum; }
    const SlopeErrors& errors() const { return errors_; }

  private:
    const ClippingFrustum& clipping_;
    std::array<LinearBound, 3> view_;
    std::array<glm::dvec4, 5> sides_;
    SlopeErrors errors_;
};

/// The values of dot(plane, (p, 1)) at the corner of each box where dot(direction, p) is largest.
template <class Number>
std::array<double, 4> valuesAt(const glm::dvec4& direction, const glm::dvec4& plane,
                               const FourBoxes<Number>& boxes) {
    const auto& x = direction.x > 0.0 ? boxes.high[0] : boxes.low[0];
    const auto& y = direction.y > 0.0 ? boxes.high[1] : boxes.low[1];
    const auto& z = direction.z > 0.0 ? boxes.high[2] : boxes.low[2];
    std::array<double, 4> values;
    for (std::size_t i = 0; i < 4; ++i)
        values[i] = plane.x * static_cast<double>(x[i]) + plane.y * static_cast<double>(y[i]) +
                    plane.z * static_cast<double>(z[i]) + plane.w;
    return values;
}

/// The largest of dot(plane, (p, 1)) over each box.
template <class Number>
std::array<double, 4> largestOf(const glm::dvec4& plane, const FourBoxes<Number>& boxes) {
    return valuesAt(plane, plane, boxes);
}

/// Tests whether surfaces in boxes, or triangles, may extend one of the known bounds. It errs on
/// the side of "may", by more than all roundings of BatchInView::add() (docs/method.md, C26).
class BoundTest {
  public:
    BoundTest(const SpaceInView& space, PartBound bound, const VisiblePart& known);

    /// Call this when the known bounds have changed.
    void follow(const VisiblePart& known);
    /// Whether no surface can extend the bound: it is at the end of its range.
    bool isSettled() const { return settled_; }

    /// How far boxes reach in the direction of the bound.
    struct Reach {
        std::array<double, 4> beyond; ///< for mayExtend()
        std::array<double, 4> value;  ///< roughly the bound's; larger is farther
    };
    template <class Number>
    Reach reachOf(const FourBoxes<Number>& boxes) const {
        if (!bySlope_) {
            const std::array<double, 4> reach = largestOf(plane_, boxes);
            return {reach, reach};
        }
        Reach reach;
        reach.value = valuesAt(plane_, across_.plane, boxes);
        const std::array<double, 4> depth = valuesAt(plane_, depth_.plane, boxes);
        const std::array<double, 4> nearness = largestOf(nearness_, boxes);
        for (std::size_t i = 0; i < 4; ++i) {
            reach.beyond[i] = reach.value[i] - slope_ * depth[i];
            if (!orthographic_) reach.value[i] = std::min(reach.value[i] / depth[i], widest_);
            if (nearness[i] < leastNearness_) continue;
            reach.beyond[i] = INFINITY;
            reach.value[i] = widest_;
        }
        return reach;
    }
    bool mayExtend(double beyond) const { return !settled_ && !(beyond <= known_); }
    bool mayExtend(const std::array<glm::dvec3, 3>& triangle) const {
        if (settled_) return false;
        return std::any_of(triangle.begin(), triangle.end(), [&](const glm::dvec3& corner) {
            const glm::dvec4 point(corner, 1.0);
            return mayExtend(glm::dot(plane_, point)) ||
                   (bySlope_ && !(glm::dot(nearness_, point) < leastNearness_));
        });
    }

  private:
    LinearBound across_; ///< coordinate of which slopes are
    LinearBound depth_;  ///< -z in camera space
    PartBound bound_;
    bool bySlope_, orthographic_, settled_ = false;
    double slopeOffset_;
    double widest_ = INFINITY; ///< the end of the bound's range
    double value_;             ///< the known one, negated if it is a low end
    double slope_ = 0.0;       ///< the known one; 0 if orthographic
    glm::dvec4 plane_{0.0};
    double known_ = 0.0; ///< reaches up to this extend nothing
    glm::dvec4 nearness_{0.0};
    double leastNearness_ = 0.0; ///< from this on, slopes may be anywhere in the window
};

} // namespace edgeshade
