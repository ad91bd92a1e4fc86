#include "src/shadow/view/bound_test.hpp"

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <limits>

namespace edgeshade {
namespace {

/// Margin for rounding, as a share of the terms: 20 times what add() and the tests can sum up
/// to.
constexpr double roundingShare = 1e-13;
/// Products below it may have underflowed.
constexpr double underflow = 1e-300;
/// Sums of terms up to it can't overflow on the way.
constexpr double overflow = 1e300;

double marginOf(double terms) {
    return terms <= overflow ? roundingShare * terms + underflow
                             : std::numeric_limits<double>::infinity();
}

LinearBound negated(const LinearBound& bound) {
    return {-bound.plane, bound.terms};
}

const Interval& slopesOf(PartBound::Of of, const Slopes& slopes) {
    return of == PartBound::Of::right ? slopes.right : slopes.up;
}

bool isSlope(PartBound::Of of) {
    return of == PartBound::Of::right || of == PartBound::Of::up;
}

glm::length_t axisOf(PartBound::Of of) {
    switch (of) {
    case PartBound::Of::right:
    case PartBound::Of::x:
        return 0;
    case PartBound::Of::up:
    case PartBound::Of::y:
        return 1;
    default:
        return 2;
    }
}

} // namespace

double PartBound::in(const VisiblePart& part) const {
    if (of == Of::depth) return high ? part.depth.farthest : part.depth.nearest;
    if (isSlope(of)) return high ? slopesOf(of, part.slopes).high : slopesOf(of, part.slopes).low;
    return (high ? part.box.high : part.box.low)[axisOf(of)];
}

SpaceInView::SpaceInView(const ClippingFrustum& clipping, const glm::dmat4& viewFromSpace,
                         const glm::dvec3& farthest, const SlopeErrors& errors)
    : clipping_(clipping), errors_(errors) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row = glm::row(viewFromSpace, axis);
        view_[axis] = {row, glm::dot(glm::abs(row), glm::dvec4(farthest, 1.0))};
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const Side& side = clipping.sides[i];
        double terms = std::abs(side.offset);
        sides_[i] = {0.0, 0.0, 0.0, side.offset};
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            sides_[i] += side.normal[axis] * view_[axis].plane;
            terms += std::abs(side.normal[axis]) * view_[axis].terms;
        }
        sides_[i].w += marginOf(terms);
    }
}

LinearBound SpaceInView::world(glm::length_t axis) const {
    const glm::dvec4 row = glm::row(clipping_.worldFromView, axis);
    LinearBound result{{0.0, 0.0, 0.0, row.w}, std::abs(row.w)};
    for (glm::length_t i = 0; i < 3; ++i) {
        result.plane += row[i] * view_[i].plane;
        result.terms += std::abs(row[i]) * view_[i].terms;
    }
    return result;
}

BoundTest::BoundTest(const SpaceInView& space, PartBound bound, const VisiblePart& known)
    : depth_(negated(space.view(2))), bound_(bound), bySlope_(isSlope(bound.of)),
      orthographic_(space.frustum().orthographic), slopeOffset_(space.errors().offset) {
    across_ = bound.of == PartBound::Of::depth ? depth_
              : bySlope_                       ? space.view(axisOf(bound.of))
                                               : space.world(axisOf(bound.of));
    if (!bound.high) across_ = negated(across_);
    plane_ = across_.plane;
    if (bound.of == PartBound::Of::depth && !bound.high) widest_ = 0.0;
    if (bySlope_) {
        const Frustum& frustum = space.frustum();
        const glm::length_t axis = axisOf(bound.of);
        widest_ = bound.high ? frustum.high[axis] : -frustum.low[axis];
        nearness_ = -depth_.plane;
        leastNearness_ = -space.errors().nearest - marginOf(depth_.terms);
    }
    value_ = std::numeric_limits<double>::quiet_NaN();
    follow(known);
}

void BoundTest::follow(const VisiblePart& known) {
    const double value = bound_.high ? bound_.in(known) : -bound_.in(known);
    if (value == value_) return;
    value_ = value;
    settled_ = value >= widest_;
    if (!bySlope_) {
        known_ = value - marginOf(across_.terms + std::abs(value));
        return;
    }
    // Slopes beyond the known one: (across + offset) / depth > value.
    const double terms = across_.terms + slopeOffset_;
    if (orthographic_) {
        known_ = value - slopeOffset_ - marginOf(terms + std::abs(value));
        return;
    }
    slope_ = value;
    plane_ = across_.plane - slope_ * depth_.plane;
    known_ = -slopeOffset_ - marginOf(terms + std::abs(value) * depth_.terms);
}

} // namespace edgeshade
