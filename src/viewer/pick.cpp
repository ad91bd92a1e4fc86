#include "src/viewer/pick.hpp"

#include <limits>

namespace edgeshade::viewer {
namespace {

/// The ray's parameter at a triangle, from either side (Moeller and Trumbore 1997); infinity where
/// it misses.
double distanceTo(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    constexpr double miss = std::numeric_limits<double>::infinity();
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return miss;
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
        if (batch.ground) continue;
        const glm::dmat4 batchFromWorld = glm::inverse(batch.worldFromBatch);
        // The direction keeps its length through the transform, so parameters stay distances.
        const Ray local{glm::dvec3(batchFromWorld * glm::dvec4(ray.from, 1.0)),
                        glm::dvec3(batchFromWorld * glm::dvec4(ray.direction, 0.0))};
        for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3)
            nearest = std::min(nearest, distanceTo(local, batch.positions[batch.indices[i]],
                                                   batch.positions[batch.indices[i + 1]],
                                                   batch.positions[batch.indices[i + 2]]));
    }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return ray.from + nearest * ray.direction;
}

} // namespace edgeshade::viewer
