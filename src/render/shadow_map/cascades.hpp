#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A rectangle perpendicular to a directional light, around visible geometry or casters; x and y
/// are the light's axes in the world. No half is 0.
struct CascadeSquare {
    glm::dvec2 middle{0.0};
    glm::dvec2 half{0.0};

    bool operator==(const CascadeSquare&) const = default;
};

/// The far ends of `count` parts of the depths from `near` to `far`, between parts of equal ratios
/// and parts of equal lengths (Zhang et al. 2006). 0 < near < far.
std::vector<double> cascadeEnds(double near, double far, int count);

/// The parts of the casters' rectangle that a directional light's maps show, the finest first.
/// Everything that `frame` shows is in one of them or outside the casters' rectangle, where nothing
/// is in shadow. There are at least 1 and at most `count`: the first part that holds all casters is
/// the last.
///
/// Cascades don't shimmer. Each is as large as a ball around its part of the frustum, which turning
/// the camera doesn't change; depths change in steps of 19 %. Each moves by whole texels, of which
/// `texels` are along an edge of its inner part. Along an axis where the casters need less than the
/// ball, their extent decides instead.
std::vector<CascadeSquare> cascadeSquares(const FrameView& frame, const glm::dmat3& worldFromLight,
                                          const CascadeSquare& casters, int count, double texels);

} // namespace edgeshade
