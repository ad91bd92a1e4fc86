#include "src/render/frame/volume_tint_pass.hpp"

#include "src/render/frame/frame.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

VolumeTintPass::VolumeTintPass(MultiplicityMethod method, SidesLayout layout,
                               std::optional<gl::Instancing> instancing) {
    if (method == MultiplicityMethod::plane) {
        adapted_.emplace(layout, instancing, std::vector<std::string>(),
                         VolumeTints{{1.0f, 0.5f, 0.1f, 0.10f},
                                     {1.0f, 0.1f, 0.2f, 0.14f},
                                     {0.1f, 0.8f, 0.2f, 0.12f},
                                     {0.15f, 0.4f, 1.0f, 0.10f}});
    } else {
        sides_.emplace(method, layout, instancing,
                       std::vector<std::string>{"TINT vec4(1.0, 0.5, 0.1, 0.10)"});
        caps_.emplace(method, layout, instancing,
                      std::vector<std::string>{"TINT vec4(0.15, 0.4, 1.0, 0.10)"});
    }
}

void VolumeTintPass::drawAdapted(const GpuBatch& batch, const GpuScene& scene,
                                 const FrameView& view, const DepthSlice& slice, const Light& light,
                                 const glm::mat4& clipFromObject) {
    const AdaptedBuffers& buffers = *batch.volumes.adapted;
    const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
    const PlanView planned = planView(view, slice, light, batch.worldFromBatch);
    for (const VolumeDraw& draw : planVolumes(*buffers.shadow(), planned).draws) {
        for (const Times times : {Times::once, Times::twice})
            adapted_->drawSides(buffers, nullptr, draw, times, endOf(draw, planned), lightHere,
                                clipFromObject);
        glDisable(GL_DEPTH_TEST);
        adapted_->drawCaps(buffers, nullptr, draw, scene.materials, scene.textures, lightHere,
                           clipFromObject);
        glEnable(GL_DEPTH_TEST);
    }
}

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
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        if (scene.batches[i].hidden) continue;
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            surfaces_.draw(scene, scene.batches[i], batchViews[i], view.frustum.position(),
                           SurfaceShading(), kind);
    }

    glDepthMask(GL_FALSE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const GpuBatch& batch = scene.batches[i];
        if (batch.hidden) continue;
        if (adapted_) {
            drawAdapted(batch, scene, view, whole, light, batchViews[i].clipFromObject);
            continue;
        }
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        sides_->draw(*batch.volumes.published, lightHere, batchViews[i].clipFromObject);
        glDisable(GL_DEPTH_TEST);
        caps_->draw(*batch.volumes.published, scene.materials, scene.textures, lightHere,
                    batchViews[i].clipFromObject, false);
        glEnable(GL_DEPTH_TEST);
    }
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace edgeshade
