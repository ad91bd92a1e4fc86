#include "src/shadow/view/light_reach.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/lights/light_cone.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Bounds of x / depth over the part of a disc at depth >= near. The part is convex, so the
/// extremes are where a line through the eye touches the circle, or at the ends of the near plane's
/// chord.
Interval slopesOver(double x, double depth, double radius, double near) {
    Interval slopes;
    const double squared = x * x + depth * depth - radius * radius; // the tangents' squared length
    if (squared > 0.0) {
        const double length = std::sqrt(squared);
        const double distance = std::hypot(x, depth);
        for (const double side : {-1.0, 1.0}) {
            // The centre's direction rotated by the tangent's angle, at the tangent's length.
            const double cosine = length / distance, sine = side * radius / distance;
            const double atX = (x * cosine + depth * sine) * length / distance;
            const double atDepth = (depth * cosine - x * sine) * length / distance;
            if (atDepth >= near) slopes.add(atX / atDepth);
        }
    }
    const double toNear = near - depth;
    if (std::abs(toNear) <= radius) {
        const double half = std::sqrt(radius * radius - toNear * toNear);
        slopes.add((x - half) / near);
        slopes.add((x + half) / near);
    }
    return slopes;
}

/// First pixel and number of pixels that the slopes cover, with one more on both sides. `low`,
/// `high`: the window's ends.
std::pair<int, int> pixelsOf(const Interval& slopes, double low, double high, int count) {
    const auto pixel = [&](double slope) {
        return std::clamp((slope - low) / (high - low) * count, -2.0, count + 2.0);
    };
    const int first = std::max(0, static_cast<int>(std::floor(pixel(slopes.low))) - 1);
    const int end = std::min(count, static_cast<int>(std::ceil(pixel(slopes.high))) + 1);
    return {first, std::max(0, end - first)};
}

/// The pixels that the slopes cover in both directions; may be empty.
PixelRectangle pixelsOf(const Slopes& slopes, const FrameView& view) {
    const glm::dvec2 &low = view.frustum.low, &high = view.frustum.high;
    const auto [x, width] = pixelsOf(slopes.right, low.x, high.x, view.width);
    const auto [y, height] = pixelsOf(slopes.up, low.y, high.y, view.height);
    if (width == 0 || height == 0) return {};
    return {x, y, width, height};
}

/// The pixels around the part of a ball between two depths.
PixelRectangle pixelsAround(const Ball& ball, const Interval& depths, const FrameView& view) {
    const glm::dvec3 center(view.frustum.viewFromWorld * glm::dvec4(ball.center, 1.0));
    const double depth = -center.z, radius = ball.radius;
    if (depth + radius < depths.low || depth - radius > depths.high) return {};
    if (view.frustum.orthographic)
        return pixelsOf(
            {{center.x - radius, center.x + radius}, {center.y - radius, center.y + radius}}, view);
    return pixelsOf({slopesOver(center.x, depth, radius, depths.low),
                     slopesOver(center.y, depth, radius, depths.low)},
                    view);
}

/// The pixels around the part of the corners' hull between two depths. It uses lines between any
/// two corners: they are in the hull, and include all its edges.
template <std::size_t Count>
PixelRectangle pixelsAround(const std::array<glm::dvec3, Count>& corners, const Interval& depths,
                            const FrameView& view) {
    const bool orthographic = view.frustum.orthographic;
    std::array<glm::dvec3, Count> seen;
    std::transform(corners.begin(), corners.end(), seen.begin(), [&](const glm::dvec3& corner) {
        return glm::dvec3(view.frustum.viewFromWorld * glm::dvec4(corner, 1.0));
    });
    Slopes slopes;
    const auto add = [&](const glm::dvec3& point) {
        const double scale = orthographic ? 1.0 : -point.z;
        slopes.right.add(point.x / scale);
        slopes.up.add(point.y / scale);
    };
    for (const glm::dvec3& a : seen) {
        if (depths.low <= -a.z && -a.z <= depths.high) add(a);
        for (const glm::dvec3& b : seen)
            for (const double depth : {depths.low, depths.high})
                if (-a.z < depth && depth < -b.z) add(a + (b - a) * ((depth + a.z) / (a.z - b.z)));
    }
    if (slopes.right.low > slopes.right.high) return {};
    return pixelsOf(slopes, view);
}

/// The longest distance at which a spot can light visible geometry; infinite if unknown.
double reachOf(const FrameView& view, const Light& spot) {
    double reach = spot.hasRange() ? spot.range : std::numeric_limits<double>::infinity();
    if (view.visible.empty()) return reach;
    double farthest = 0.0;
    for (int corner = 0; corner < 8; ++corner)
        farthest = std::max(farthest,
                            glm::distance(view.visible.corner(corner), glm::dvec3(spot.position)));
    return std::min(reach, farthest);
}

PixelRectangle spotReach(const FrameView& view, const Interval& depths, const Light& spot) {
    const auto misses = [&](const glm::dvec4& plane) { return isOutside(view.visible, plane); };
    const ConePlanes planes = planesAround(spot);
    if (!view.visible.empty() && std::any_of(planes.begin(), planes.end(), misses)) return {};
    if (!view.visible.empty() && spot.hasRange() &&
        isBeyond(view.visible, glm::dvec3(spot.position), spot.range))
        return {};
    const double reach = reachOf(view, spot);
    if (!std::isfinite(reach)) return {0, 0, view.width, view.height};
    const PixelRectangle pixels = pixelsAround(ballAround(spot, reach), depths, view);
    if (!hasPyramid(spot)) return pixels;
    return intersection(pixels, pixelsAround(pyramidAround(spot, reach), depths, view));
}

/// Room for the rounding of what is visible, as a share of its size.
constexpr double visibleRounding = 1e-6;

/// How many times `step` a point of `casters` can be moved until it has left `visible`.
double mostSteps(const Box& casters, const glm::dvec3& step, const Box& visible) {
    const double room = visibleRounding * visible.diagonal();
    double most = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        if (step[k] > 0.0)
            most = std::min(most, (visible.high[k] - casters.low[k] + room) / step[k]);
        if (step[k] < 0.0)
            most = std::min(most, (visible.low[k] - casters.high[k] - room) / step[k]);
    }
    return most;
}

/// How many times as far from `light` as a point of `casters` a point of `visible` behind it can
/// be.
double mostTimes(const Box& casters, const glm::dvec3& light, const Box& visible) {
    const double room = visibleRounding * visible.diagonal();
    const glm::dvec3 low = casters.low - light, high = casters.high - light;
    double most = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        if (low[k] > 0.0) most = std::min(most, (visible.high[k] - light[k] + room) / low[k]);
        if (high[k] < 0.0) most = std::min(most, (visible.low[k] - light[k] - room) / high[k]);
    }
    return most;
}

} // namespace

PixelRectangle visiblePixels(const FrameView& view) {
    if (view.visible.empty()) return {0, 0, view.width, view.height};
    return pixelsOf(view.slopes, view);
}

PixelRectangle lightReach(const FrameView& view, const DepthSlice& slice, const Light& light) {
    const Interval depths{slice.near, std::min(slice.far, view.farthestDepth) * (1.0 + 1e-3)};
    if (light.isSpot()) return spotReach(view, depths, light);
    if (!light.hasRange()) return {0, 0, view.width, view.height};
    if (!view.visible.empty() && isBeyond(view.visible, glm::dvec3(light.position), light.range))
        return {};
    return pixelsAround(Ball{glm::dvec3(light.position), rangeWidening * light.range}, depths,
                        view);
}

PixelRectangle shadowReach(const FrameView& view, const Box& casters, const Light& light) {
    const PixelRectangle whole{0, 0, view.width, view.height};
    if (casters.empty()) return {};
    if (view.visible.empty()) return whole;
    Box both = view.visible;
    both.add(casters);
    const bool directional = light.position.w == 0.0;
    const glm::dvec3 place(light.position);
    // A shadowed point is on the ray from the light through a point of the box, at most `farther`
    // times as far from the light; or from a sun at most the diagonal of everything behind it.
    double farther = 0.0;
    if (!directional) {
        const double nearest = casters.distanceTo(place);
        for (int corner = 0; corner < 8; ++corner)
            farther = std::max(farther, glm::distance(place, both.corner(corner)));
        if (nearest * 1e6 <= farther) return whole;
        farther /= nearest;
    }
    const glm::dvec3 away = directional ? -glm::normalize(place) : glm::dvec3(0.0);
    const double most = directional
                            ? std::min(both.diagonal(), mostSteps(casters, away, view.visible))
                            : std::min(farther, mostTimes(casters, place, view.visible));
    if (most < (directional ? 0.0 : 1.0)) return {};
    std::array<glm::dvec3, 16> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = casters.corner(i);
        const auto at = static_cast<std::size_t>(2 * i);
        corners[at] = corner;
        corners[at + 1] = directional ? corner + away * most : place + (corner - place) * most;
    }
    return intersection(
        whole, pixelsAround(corners, {view.near(), view.farthestDepth * (1.0 + 1e-3)}, view));
}

PixelRectangle scaledReach(const PixelRectangle& reach, const FrameView& view,
                           const glm::ivec2& size) {
    const auto scaled = [](int first, int count, int from, int to) {
        const double scale = static_cast<double>(to) / from;
        const int low = static_cast<int>(std::floor(first * scale)) - 2;
        const int high = static_cast<int>(std::ceil((first + count) * scale)) + 2;
        return std::pair(low, high - low);
    };
    const auto [x, width] = scaled(reach.x, reach.width, view.width, size.x);
    const auto [y, height] = scaled(reach.y, reach.height, view.height, size.y);
    return intersection({x, y, width, height}, {0, 0, size.x, size.y});
}

} // namespace edgeshade
