#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A rectangle across a directional light: of what is visible, or of casters, by the light's axes
/// (x, y) in the world. No half is 0.
struct CascadeSquare {
    glm::dvec2 middle{0.0};
    glm::dvec2 half{0.0};

    bool operator==(const CascadeSquare&) const = default;
};

/// Where `count` parts of the depths from `near` to `far` end (Zhang et al. 2006): between parts of
/// equal ratios and parts of equal lengths. 0 < near < far.
std::vector<double> cascadeEnds(double near, double far, int count);

/// The parts of the casters' rectangle that maps of a directional light show, the finest first, so
/// that all that `frame` shows is in one of them or outside the casters' rectangle, where nothing
/// is dark. At least 1, at most `count`: the first that holds all casters is the last.
///
/// They don't shimmer: each is as large as a ball around its part of the frustum, which no turn of
/// the camera changes, depths in steps of 19 %, and moves by whole texels, of which `texels` are
/// along an edge of its inner part. Only along an axis where casters take less than the ball they
/// decide.
std::vector<CascadeSquare> cascadeSquares(const FrameView& frame, const glm::dmat3& worldFromLight,
                                          const CascadeSquare& casters, int count, double texels);

} // namespace edgeshade
