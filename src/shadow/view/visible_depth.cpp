#include "src/shadow/view/visible_depth.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the window, against rounding

/// Corners of the triangles that are first tested together: neighbours in a file are mostly close
/// together.
constexpr std::size_t runCorners = 3 * 64;

/// Bound of a GL's error in placing points, in the view. `farthest`: the largest magnitudes of
/// their coordinates.
double placingErrorOf(const glm::dvec3& farthest, const glm::dmat4& viewFromBatch) {
    double largest = 0.0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row = glm::abs(glm::row(viewFromBatch, axis));
        largest = std::max(largest, glm::dot(row, glm::dvec4(farthest, 1.0)));
    }
    return placingError * largest;
}

glm::dvec3 farthestOf(const std::vector<glm::vec3>& positions) {
    glm::dvec3 farthest(0.0);
    for (const glm::vec3& position : positions)
        farthest = glm::max(farthest, glm::dvec3(glm::abs(position)));
    return farthest;
}

/// The frustum with its window enlarged by the factor `widening`.
Frustum widened(Frustum frustum) {
    const glm::dvec2 more = 0.5 * (widening - 1.0) * frustum.size();
    frustum.low -= more;
    frustum.high += more;
    return frustum;
}

/// A side of the frustum in camera space: dot(normal, p) + offset >= 0 inside.
struct Side {
    glm::dvec3 normal;
    double offset;
};
std::array<Side, 5> sidesOf(const Frustum& frustum) {
    const glm::dvec2 &low = frustum.low, &high = frustum.high;
    const Side front = {{0.0, 0.0, -1.0}, 0.0};
    if (frustum.orthographic)
        return {Side{{1.0, 0.0, 0.0}, -low.x}, Side{{-1.0, 0.0, 0.0}, high.x},
                Side{{0.0, 1.0, 0.0}, -low.y}, Side{{0.0, -1.0, 0.0}, high.y}, front};
    return {Side{{1.0, 0.0, low.x}, 0.0}, Side{{-1.0, 0.0, -high.x}, 0.0},
            Side{{0.0, 1.0, low.y}, 0.0}, Side{{0.0, -1.0, -high.y}, 0.0}, front};
}

/// Bounds of the slopes of the frustum's points, each placed with an error of up to `error`.
class SlopeBounds {
  public:
    SlopeBounds(const Frustum& frustum, double error, const Slopes& known = {})
        : frustum_(frustum), nearest_(frustum.orthographic ? 0.0 : 2.0 * error), error_(error),
          slopes_(known) {
        if (frustum.orthographic) return;
        const glm::dvec2 widest = glm::max(glm::abs(frustum.low), glm::abs(frustum.high));
        error_ = 2.0 * error * (1.0 + std::max(widest.x, widest.y));
    }

    /// Whether a point, in the frustum or not, is already within the bounds.
    bool hold(const glm::dvec3& point) const {
        const double depth = -point.z;
        return depth > nearest_ && hold(slopes_.right, point.x, perUnit(depth)) &&
               hold(slopes_.up, point.y, perUnit(depth));
    }
    void add(const glm::dvec3& point) {
        add(slopes_.right, point.x, -point.z, frustum_.low.x, frustum_.high.x);
        add(slopes_.up, point.y, -point.z, frustum_.low.y, frustum_.high.y);
    }
    const Slopes& slopes() const { return slopes_; }

  private:
    /// Factor from window coordinates to positions at a depth.
    double perUnit(double depth) const { return frustum_.orthographic ? 1.0 : depth; }
    bool hold(const Interval& known, double offset, double unit) const {
        return known.low * unit <= offset - error_ && offset + error_ <= known.high * unit;
    }
    void add(Interval& known, double offset, double depth, double low, double high) const {
        // x / d, with errors of e in both, is off by at most e (1 + |x / d|) / (d - e). As d > 2 e,
        // that is at most 2 e (1 + |x / d|) / d.
        for (const double error : {-error_, error_})
            known.add(depth > nearest_ ? std::clamp((offset + error) / perUnit(depth), low, high)
                      : error < 0.0    ? low
                                       : high);
    }

    Frustum frustum_;
    double nearest_, error_;
    Slopes slopes_;
};

/// Whether a triangle in the picture's camera space certainly shows its back. `mirrored`: its
/// transform reverses winding; `error`: bound of a GL's error in placing its corners.
bool showsBack(const Polygon& triangle, bool orthographic, bool mirrored, double error) {
    const glm::dvec3 &a = triangle.corners[0], &b = triangle.corners[1], &c = triangle.corners[2];
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 towardsEye = orthographic ? glm::dvec3(0.0, 0.0, 1.0) : -a;
    const double side = (mirrored ? -1.0 : 1.0) * glm::dot(glm::cross(ab, ac), towardsEye);
    const double sides = glm::length(ab) + glm::length(ac) + error;
    return side < -4.0 * error * sides * (sides + glm::length(towardsEye));
}

/// Whether the whole box, in the picture's camera space, is outside the frustum.
bool isOutsideOf(const std::array<Side, 5>& sides, const Box& box) {
    return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
        return largestOver(box, glm::dvec4(side.normal, side.offset)) < 0.0;
    });
}

/// For each index of the batch, whether its triangle is visible only from its front.
std::vector<std::uint8_t> culledWhereTurnedAway(const Scene& scene, const Batch& batch) {
    if (!scene.culls) return {};
    std::vector<std::uint8_t> culled(batch.geometry->indices.size(), 0);
    for (const SurfaceGroup& group : batch.geometry->groups)
        std::fill_n(culled.begin() + group.firstIndex, group.indexCount,
                    !scene.materials[group.material].doubleSided);
    return culled;
}

} // namespace

VisiblePart visiblePart(const Scene& scene, const Batch& batch, const Frustum& given) {
    const Frustum frustum = widened(given);
    const std::array<Side, 5> sides = sidesOf(frustum);
    const glm::dmat4 viewFromBatch = frustum.viewFromWorld * batch.worldFromBatch;
    std::vector<glm::dvec3> points;
    points.reserve(batch.geometry->positions.size());
    for (const glm::vec3& position : batch.geometry->positions)
        points.emplace_back(viewFromBatch * glm::dvec4(position, 1.0));

    const glm::dmat4 worldFromView = glm::inverse(frustum.viewFromWorld);
    const auto inWorld = [&](const glm::dvec3& point) {
        return glm::dvec3(worldFromView * glm::dvec4(point, 1.0));
    };
    VisiblePart part;
    const double error = placingErrorOf(farthestOf(batch.geometry->positions), viewFromBatch);
    SlopeBounds slopes(frustum, error);
    const std::vector<std::uint8_t> culled = culledWhereTurnedAway(scene, batch);
    const bool mirrored = glm::determinant(glm::dmat3(viewFromBatch)) < 0.0;
    const auto& indices = batch.geometry->indices;
    const auto isKnown = [&](const glm::dvec3& point) {
        return slopes.hold(point) && part.box.holds(inWorld(point));
    };
    // Bounds that hold all corners of a box hold the whole box: slopes are planes through the eye.
    const auto addsNothing = [&](const Box& box) {
        if (isOutsideOf(sides, box)) return true;
        if (!part.depth.contains(-box.high.z, -box.low.z)) return false;
        for (int i = 0; i < 8; ++i)
            if (!isKnown(box.corner(i))) return false;
        return true;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (i % runCorners == 0) {
            const std::size_t end = std::min(i + runCorners, indices.size());
            Box around;
            for (std::size_t c = i; c < end; ++c)
                around.add(points[indices[c]]);
            if (addsNothing(around)) {
                i = end - 3;
                continue;
            }
        }
        Polygon polygon;
        DepthRange whole;
        for (std::size_t c = 0; c < 3; ++c) {
            polygon.add(points[indices[i + c]]);
            whole.add(-polygon.corners[c].z);
        }
        const bool known =
            part.depth.contains(whole.nearest, whole.farthest) &&
            std::all_of(polygon.corners.begin(), polygon.corners.begin() + 3, isKnown);
        if (known) continue;
        if (!culled.empty() && culled[i] &&
            showsBack(polygon, frustum.orthographic, mirrored, error))
            continue;
        for (const Side& side : sides) {
            polygon = clipped(polygon, side.normal, side.offset);
            if (polygon.count == 0) break;
        }
        for (std::size_t c = 0; c < polygon.count; ++c) {
            part.depth.add(std::max(0.0, -polygon.corners[c].z));
            part.box.add(inWorld(polygon.corners[c]));
            slopes.add(polygon.corners[c]);
        }
    }
    part.slopes = slopes.slopes();
    return part;
}

std::optional<double> nearestOfKnown(const VisiblePart& known, const Box& box,
                                     const glm::dmat4& worldFromBatch, const Frustum& given) {
    const Frustum frustum = widened(given);
    const glm::dmat4 viewFromBatch = frustum.viewFromWorld * worldFromBatch;
    std::array<glm::dvec3, 8> corners;
    DepthRange depth;
    for (int i = 0; i < 8; ++i) {
        corners[i] = glm::dvec3(viewFromBatch * glm::dvec4(box.corner(i), 1.0));
        depth.add(-corners[i].z);
    }
    for (const Side& side : sidesOf(frustum))
        if (std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
                return glm::dot(side.normal, corner) + side.offset < 0.0;
            }))
            return std::numeric_limits<double>::infinity();
    if (!known.depth.contains(depth.nearest, depth.farthest)) return std::nullopt;
    // Bounds that hold all corners of the box hold the whole box: slopes are planes through the
    // eye.
    const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    const SlopeBounds slopes(frustum, placingErrorOf(farthest, viewFromBatch), known.slopes);
    for (int i = 0; i < 8; ++i)
        if (!slopes.hold(corners[i]) ||
            !known.box.holds(glm::dvec3(worldFromBatch * glm::dvec4(box.corner(i), 1.0))))
            return std::nullopt;
    return std::max(0.0, depth.nearest);
}

bool isAboveGround(const Frustum& frustum, const Batch& ground) {
    const glm::dvec4 eye = frustum.eye();
    return eye.y > ground.worldFromBatch[3].y * eye.w;
}

} // namespace edgeshade
