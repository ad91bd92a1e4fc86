#include "src/viewer/volume_tint_pass.hpp"

#include "src/render/frame.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::viewer {

VolumeTintPass::VolumeTintPass(MultiplicityMethod method, SidesLayout layout,
                               std::optional<gl::Instancing> instancing)
    : sides_(method, layout, instancing, {"TINT vec4(1.0, 0.5, 0.1, 0.10)"}),
      caps_(method, layout, instancing, {"TINT vec4(0.15, 0.4, 1.0, 0.10)"}) {}

void VolumeTintPass::draw(const GpuScene& scene, const FrameView& view, const Light& light) {
    const DepthSlice whole{view.near(), std::numeric_limits<double>::infinity()};
    std::vector<BatchView> batchViews;
    for (const GpuBatch& batch : scene.batches)
        batchViews.push_back(batchViewOf(batch, view, whole));

    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glClear(GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < scene.batches.size(); ++i)
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            surfaces_.draw(scene, scene.batches[i], batchViews[i], view.camera.from,
                           SurfaceShading(), kind);

    glDepthMask(GL_FALSE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const GpuBatch& batch = scene.batches[i];
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        sides_.draw(batch.shadow, lightHere, batchViews[i].clipFromObject);
        glDisable(GL_DEPTH_TEST);
        caps_.draw(batch.shadow, scene.materials, scene.textures, lightHere,
                   batchViews[i].clipFromObject, false);
        glEnable(GL_DEPTH_TEST);
    }
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace edgeshade::viewer
