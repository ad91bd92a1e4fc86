#include "src/render/shadow_map/cascades.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Weight of equal ratios in the splits: a larger weight makes the first cascades finer. Not tuned
/// by measurement.
constexpr double ratioShare = 0.75;

/// Steps per octave to which depths are rounded, since visible depths change from frame to frame.
constexpr double stepsOfTwo = 4.0;

double stepBelow(double depth) {
    return std::exp2(std::floor(std::log2(depth) * stepsOfTwo) / stepsOfTwo);
}
double stepAbove(double depth) {
    return std::exp2(std::ceil(std::log2(depth) * stepsOfTwo) / stepsOfTwo);
}

/// The depths to divide.
DepthRange visibleDepths(const FrameView& frame) {
    DepthRange depths{frame.near(), std::max(frame.farthestDepth, frame.near())};
    if (frame.frustum.orthographic)
        return depths; // depths may have any sign, and need no finer
                       // part
    depths.nearest = stepBelow(depths.nearest);
    depths.farthest = std::max(stepAbove(depths.farthest), 1.01 * depths.nearest);
    return depths;
}

struct WindowBall {
    glm::dvec3 middle{0.0}; ///< in view space
    double radius = 0.0;
};

/// A ball around the part of the frustum between two depths. Depends on these and on the window
/// alone, bit for bit.
WindowBall ballAround(const Frustum& frustum, double near, double far) {
    const glm::dvec2 center = 0.5 * (frustum.low + frustum.high), half = 0.5 * frustum.size();
    const auto at = [&](const glm::dvec2& window, double depth) {
        const double wide = frustum.orthographic ? 1.0 : depth;
        return glm::dvec3(window * wide, -depth);
    };
    // Equally far from the corners of both ends, if that point lies between them.
    double depth = 0.5 * (near + far);
    if (!frustum.orthographic) depth = std::min(depth * (1.0 + glm::dot(half, half)), far);
    WindowBall ball;
    ball.middle = at(center, depth);
    for (const double end : {near, far})
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                ball.radius =
                    std::max(ball.radius,
                             glm::distance(ball.middle, at(center + glm::dvec2(x, y) * half, end)));
    return ball;
}

} // namespace

std::vector<double> cascadeEnds(double near, double far, int count) {
    std::vector<double> ends;
    for (int i = 1; i <= count; ++i) {
        const double part = static_cast<double>(i) / count;
        const double ratios = near * std::pow(far / near, part),
                     lengths = near + (far - near) * part;
        ends.push_back(i == count ? far : ratioShare * ratios + (1.0 - ratioShare) * lengths);
    }
    return ends;
}

std::vector<CascadeSquare> cascadeSquares(const FrameView& frame, const glm::dmat3& worldFromLight,
                                          const CascadeSquare& casters, int count, double texels) {
    const DepthRange depths = visibleDepths(frame);
    const glm::dmat4 worldFromView = glm::inverse(frame.frustum.viewFromWorld);
    std::vector<double> ends;
    if (frame.frustum.orthographic) // one texel per pixel suits every depth alike
        ends = {depths.farthest};
    else
        ends = cascadeEnds(depths.nearest, depths.farthest, count);
    std::vector<CascadeSquare> squares;
    double begin = depths.nearest;
    for (const double end : ends) {
        const WindowBall ball = ballAround(frame.frustum, begin, end);
        const glm::dvec3 middle(worldFromView * glm::dvec4(ball.middle, 1.0));
        CascadeSquare square;
        // Snapping moves the square by up to half a texel.
        const double half = ball.radius * texels / (texels - 1.0);
        const double texel = 2.0 * half / texels;
        bool all = true;
        for (glm::length_t axis = 0; axis < 2; ++axis) {
            const double along = glm::dot(worldFromLight[axis], middle);
            const bool holdsCasters = half >= casters.half[axis];
            square.middle[axis] =
                holdsCasters ? casters.middle[axis] : std::round(along / texel) * texel;
            square.half[axis] = holdsCasters ? casters.half[axis] : half;
            all = all && holdsCasters;
        }
        squares.push_back(square);
        begin = end;
        if (all) break;
    }
    return squares;
}

} // namespace edgeshade
