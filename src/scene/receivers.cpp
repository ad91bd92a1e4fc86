#include "src/scene/receivers.hpp"

namespace edgeshade {

Box receiversOf(const LoadedScene& loaded) {
    Box box;
    for (const Batch& batch : loaded.scene.batches)
        if (!batch.ground || loaded.showsGround)
            for (const glm::vec3& position : batch.geometry->positions)
                box.add(glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    return box;
}

} // namespace edgeshade
