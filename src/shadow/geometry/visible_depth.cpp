#include "src/shadow/geometry/visible_depth.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the pyramid, against rounding

/// How far a GL may place the points off, in the view.
double placingErrorOf(const std::vector<glm::vec3>& positions, const glm::dmat4& viewFromBatch) {
    glm::dvec3 farthest(0.0);
    for (const glm::vec3& position : positions)
        farthest = glm::max(farthest, glm::dvec3(glm::abs(position)));
    double largest = 0.0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row = glm::abs(glm::row(viewFromBatch, axis));
        largest = std::max(largest, glm::dot(row, glm::dvec4(farthest, 1.0)));
    }
    return placingError * largest;
}

/// The slopes that points of the picture's pyramid get, each placed up to `error` off.
class SlopeBounds {
  public:
    /// `widest`: slopes of the pyramid's sides.
    SlopeBounds(const glm::dvec2& widest, double error)
        : widest_(widest), nearest_(2.0 * error),
          error_(2.0 * error * (1.0 + std::max(widest.x, widest.y))) {}

    /// Whether a point, of the pyramid or not, adds nothing.
    bool hold(const glm::dvec3& point) const {
        const double depth = -point.z;
        return depth > nearest_ && hold(slopes_.right, point.x, depth) &&
               hold(slopes_.up, point.y, depth);
    }
    void add(const glm::dvec3& point) {
        add(slopes_.right, point.x, -point.z, widest_.x);
        add(slopes_.up, point.y, -point.z, widest_.y);
    }
    const Slopes& slopes() const { return slopes_; }

  private:
    bool hold(const Interval& known, double offset, double depth) const {
        return known.low * depth <= offset - error_ && offset + error_ <= known.high * depth;
    }
    void add(Interval& known, double offset, double depth, double widest) const {
        // x / d, both off by e: by at most e (1 + |x / d|) / (d - e), which is within 2 e / d of
        // it.
        for (const double error : {-error_, error_})
            known.add(depth > nearest_ ? std::clamp((offset + error) / depth, -widest, widest)
                                       : std::copysign(widest, error));
    }

    glm::dvec2 widest_;
    double nearest_, error_;
    Slopes slopes_;
};

} // namespace

VisiblePart visiblePart(const Batch& batch, const Camera& camera, double aspect) {
    const double t = widening * std::tan(glm::radians(0.5 * camera.fovDegrees));
    // Planes through the eye in camera space, insides positive; the last keeps what is in front.
    const glm::dvec3 planes[] = {{1.0, 0.0, -t * aspect},
                                 {-1.0, 0.0, -t * aspect},
                                 {0.0, 1.0, -t},
                                 {0.0, -1.0, -t},
                                 {0.0, 0.0, -1.0}};
    const glm::dmat4 viewFromBatch = viewFromWorld(camera) * batch.worldFromBatch;
    std::vector<glm::dvec3> points;
    points.reserve(batch.positions.size());
    for (const glm::vec3& position : batch.positions)
        points.emplace_back(viewFromBatch * glm::dvec4(position, 1.0));

    const glm::dmat4 worldFromView = glm::inverse(viewFromWorld(camera));
    const auto inWorld = [&](const glm::dvec3& point) {
        return glm::dvec3(worldFromView * glm::dvec4(point, 1.0));
    };
    VisiblePart part;
    SlopeBounds slopes({t * aspect, t}, placingErrorOf(batch.positions, viewFromBatch));
    for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
        Polygon polygon;
        DepthRange whole;
        for (std::size_t c = 0; c < 3; ++c) {
            polygon.add(points[batch.indices[i + c]]);
            whole.add(-polygon.corners[c].z);
        }
        const bool known =
            part.depth.contains(whole.nearest, whole.farthest) &&
            std::all_of(polygon.corners.begin(), polygon.corners.begin() + 3,
                        [&](const glm::dvec3& corner) {
                            return slopes.hold(corner) && part.box.holds(inWorld(corner));
                        });
        if (known) continue;
        for (const glm::dvec3& plane : planes) {
            polygon = clipped(polygon, plane);
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

} // namespace edgeshade
