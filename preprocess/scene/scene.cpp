#include "preprocess/scene/scene.hpp"

namespace edgeshade {

Box worldBounds(const Scene& scene) {
    Box box;
    for (const Batch& batch : scene.batches) {
        if (batch.ground) continue;
        for (const glm::vec3& position : batch.positions)
            box.add(glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    }
    return box;
}

} // namespace edgeshade
