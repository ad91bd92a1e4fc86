#include "src/shadow/view/framing.hpp"

#include <algorithm>
#include <limits>

namespace edgeshade {
namespace {

constexpr double margin = 1.06;

/// Minimum depth of every vertex as a share of the scene's diagonal, slightly more than a fiftieth.
/// Without it a needle that points at the eye would have its tip there.
constexpr double leastEyeDistance = 0.02 * (1.0 + 1e-6);

/// Possible positions of an eye along one axis of the picture. A point at x to the side and z
/// towards the eye is visible from (eye, height) if |x - eye| <= tangent * (height - z).
class Spread {
  public:
    explicit Spread(double tangent) : tangent_(tangent) {}

    void add(double x, double z) {
        right_ = std::max(right_, z + x / tangent_);
        left_ = std::max(left_, z - x / tangent_);
    }
    double eye() const { return 0.5 * tangent_ * (right_ - left_); }
    double height() const { return 0.5 * (right_ + left_); }

  private:
    double tangent_;
    double right_ = -std::numeric_limits<double>::infinity();
    double left_ = right_;
};

} // namespace

Camera framingCamera(const Scene& scene, double fovDegrees, double aspect,
                     const glm::dvec3& direction) {
    const Box box = worldBounds(scene);
    if (box.empty()) return framingCamera(box, fovDegrees, aspect, direction);
    const Camera looking{box.center() + direction, box.center(), fovDegrees};
    const glm::dmat3 axes(viewFromWorld(looking));
    const double tangentY = tangentOfHalfFov(fovDegrees) / margin;
    Spread across(tangentY * aspect), upward(tangentY);
    double nearest = -std::numeric_limits<double>::infinity();
    for (const Batch& batch : scene.whole().batches) {
        if (batch.ground || batch.hidden) continue;
        for (const glm::vec3& position : batch.geometry->positions) {
            const glm::dvec3 world(batch.worldFromBatch * glm::dvec4(position, 1.0));
            const glm::dvec3 seen = axes * (world - box.center());
            across.add(seen.x, seen.z);
            upward.add(seen.y, seen.z);
            nearest = std::max(nearest, seen.z);
        }
    }
    const double before = nearest + std::max(leastEyeDistance * box.diagonal(), 1e-9);
    const double height = std::max({across.height(), upward.height(), before});
    const glm::dmat3 worldFromAxes = glm::transpose(axes);
    const glm::dvec3 aside = worldFromAxes * glm::dvec3(across.eye(), upward.eye(), 0.0);
    Camera camera{box.center() + aside + worldFromAxes * glm::dvec3(0.0, 0.0, height),
                  box.center() + aside, fovDegrees};
    return camera;
}

} // namespace edgeshade
