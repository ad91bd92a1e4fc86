#include "src/render/drawing/batch_view.hpp"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade {

BatchView batchViewOf(const GpuBatch& batch, const FrameView& view, const DepthSlice& slice) {
    const glm::dmat4 clipFromWorld = view.clipFromView(slice) * view.frustum.viewFromWorld;
    BatchView result;
    result.eye = view.frustum.position();
    result.clipFromObject = glm::mat4(clipFromWorld * batch.worldFromBatch);
    result.eyeOffsetFromObject =
        glm::mat4(glm::translate(glm::dmat4(1.0), -result.eye) * batch.worldFromBatch);
    result.normalFromObject = glm::mat3(glm::inverseTranspose(glm::dmat3(batch.worldFromBatch)));
    result.planes = viewPlanes(view, slice, batch.worldFromBatch);
    result.alpha = batch.alpha ? &*batch.alpha : nullptr;
    result.mirrored = batch.mirrored();
    result.culls = view.culls;
    return result;
}

} // namespace edgeshade
