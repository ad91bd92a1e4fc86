#pragma once

#include "preprocess/mesh/topology.hpp"
#include "src/shadow/geometry/face_outline.hpp"
#include "src/shadow/geometry/light.hpp"

#include <vector>

namespace edgeshade {

/// The scene as a light sees it: rays to its points, on the six faces of a cube around a point
/// light or on the one plane across a directional light, where a ray is the point (x, y, 1).
struct LightView {
    explicit LightView(const Light& light);

    glm::dvec3 rayTo(const glm::dvec3& world) const {
        return directional ? glm::dvec3(glm::dot(across, world), glm::dot(upward, world), 1.0)
                           : world - position;
    }
    /// A face as far as it goes.
    Outline wholeFace() const {
        const double end = directional ? INFINITY : 1.0;
        return {-end, end, -end, end};
    }

    bool directional;
    glm::dvec3 position; ///< of a point light
    double range;        ///< likewise; casters beyond shade nothing that it reaches
    glm::dvec3 across{0.0}, upward{0.0};
    std::vector<glm::dmat3> faces;
};

/// Calls visit(rays to the corners) for every casting triangle, in the order of batches and their
/// casters.
template <class Visit>
void forEachCaster(const Scene& scene, bool castMasked, const LightView& from, Visit visit) {
    std::vector<glm::dvec3> rays;
    for (const Batch& batch : scene.batches) {
        rays.clear();
        for (const glm::vec3& position : batch.geometry->positions)
            rays.push_back(from.rayTo(batch.worldFromBatch * glm::dvec4(position, 1.0)));
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        for (std::size_t i = 0; i + 2 < casters.indices.size(); i += 3)
            visit(std::array{rays[casters.indices[i]], rays[casters.indices[i + 1]],
                             rays[casters.indices[i + 2]]});
    }
}

} // namespace edgeshade
