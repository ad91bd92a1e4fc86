#include "src/lab/draw.hpp"

namespace edgeshade::lab {

SurfacePoint surfacePoint(const Scene& scene, Draw& draw) {
    for (int attempt = 0; attempt < 64; ++attempt) {
        const std::size_t triangles = scene.triangleCount();
        if (triangles == 0) break;
        std::size_t index = draw.below(triangles);
        for (const Batch& batch : scene.batches) {
            if (index >= batch.geometry->indices.size() / 3) {
                index -= batch.geometry->indices.size() / 3;
                continue;
            }
            glm::dvec3 corner[3];
            for (std::size_t c = 0; c < 3; ++c)
                corner[c] = glm::dvec3(
                    batch.worldFromBatch *
                    glm::dvec4(batch.geometry->positions[batch.geometry->indices[3 * index + c]],
                               1.0));
            const glm::dvec3 cross = (batch.isMirrored() ? -1.0 : 1.0) *
                                     glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
            const double length = glm::length(cross);
            if (length > 0.0) return {(corner[0] + corner[1] + corner[2]) / 3.0, cross / length};
            break;
        }
    }
    return {};
}

} // namespace edgeshade::lab
