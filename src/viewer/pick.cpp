#include "src/viewer/pick.hpp"

#include <limits>

namespace edgeshade::viewer {
namespace {

/// The ray's parameter at a triangle (Moeller and Trumbore 1997), from either side or only from its
/// front; infinity if it misses.
double distanceTo(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  bool frontAlone) {
    constexpr double miss = std::numeric_limits<double>::infinity();
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p); // above 0 if the ray meets the front
    if (determinant == 0.0 || (frontAlone && determinant < 0.0)) return miss;
    const glm::dvec3 offset = ray.from - a;
    const double u = glm::dot(offset, p) / determinant;
    if (u < 0.0 || u > 1.0) return miss;
    const glm::dvec3 q = glm::cross(offset, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (v < 0.0 || u + v > 1.0) return miss;
    const double distance = glm::dot(ac, q) / determinant;
    return distance > 0.0 ? distance : miss;
}

} // namespace

std::optional<glm::dvec3> firstHit(const Scene& scene, const Ray& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Batch& batch : scene.batches) {
        if (batch.ground || batch.hidden) continue;
        const glm::dmat4 batchFromWorld = glm::inverse(batch.worldFromBatch);
        // The transform keeps the direction's length, so parameters stay distances.
        const Ray local{glm::dvec3(batchFromWorld * glm::dvec4(ray.from, 1.0)),
                        glm::dvec3(batchFromWorld * glm::dvec4(ray.direction, 0.0))};
        for (const SurfaceGroup& group : batch.geometry->groups) {
            if (!scene.materials[group.material].isSeen()) continue;
            const bool frontAlone = scene.culls && !scene.materials[group.material].doubleSided;
            const std::uint32_t end = group.firstIndex + group.indexCount;
            for (std::uint32_t i = group.firstIndex; i + 2 < end; i += 3)
                nearest = std::min(
                    nearest,
                    distanceTo(local, batch.geometry->positions[batch.geometry->indices[i]],
                               batch.geometry->positions[batch.geometry->indices[i + 1]],
                               batch.geometry->positions[batch.geometry->indices[i + 2]],
                               frontAlone));
        }
    }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return ray.from + nearest * ray.direction;
}

} // namespace edgeshade::viewer
