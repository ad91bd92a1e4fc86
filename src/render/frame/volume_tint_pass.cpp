#include "src/render/frame/volume_tint_pass.hpp"

#include "src/gl/scissor.hpp"
#include "src/render/volumes/stencil_count.hpp"
#include "src/render/volumes/volume_counter.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

const VolumeTints VolumeTintPass::tints = {{1.0f, 0.5f, 0.1f, 0.10f},
                                           {1.0f, 0.1f, 0.2f, 0.14f},
                                           {0.1f, 0.8f, 0.2f, 0.12f},
                                           {0.15f, 0.4f, 1.0f, 0.10f}};

VolumeTintPass::VolumeTintPass(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : surfaces_(capabilities), volumes_(makeVolumeRenderer(settings, capabilities, tints)) {}

void VolumeTintPass::draw(GpuScene& scene, const FrameView& view, const FramePlan& plan,
                          std::size_t light) {
    volumes_->beginFrame(scene, PotentialSilhouettes::unlimited);
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_STENCIL_TEST);
    clearStencil();
    // Slices claim the pixels that show their surfaces from near to far, with descending numbers,
    // so that GEQUAL excludes the pixels of nearer slices.
    for (std::size_t s = plan.slices.size(); s-- > 0 && light < plan.slices[s].lights.size();) {
        const LightPlan& planned = plan.slices[s].lights[light];
        const auto number = static_cast<GLint>(s + 1);
        glStencilFunc(GL_GEQUAL, number, 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        drawSurfaces(scene, view, view.slices[s]);
        glStencilFunc(s == 0 ? GL_GEQUAL : GL_EQUAL, number, 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        const gl::ScissorScope cut(planned.reach);
        for (std::size_t group = 0; group < planned.counts.size(); ++group) {
            const CountPlan& count = planned.counts[group];
            const CasterGroupInSlice casters{view, view.slices[s], light, group};
            volumes_->prepare(count, scene, casters);
            tint(count.draws.once, count, scene, casters);
            tint(count.draws.twice, count, scene, casters);
        }
    }
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VolumeTintPass::drawSurfaces(const GpuScene& scene, const FrameView& view,
                                  const DepthSlice& slice) {
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    SurfaceShading shading;
    shading.farthest = static_cast<float>(slice.far);
    for (const GpuBatch& batch : scene.batches)
        if (!batch.hidden) surfaces_.draw(scene, batch, batchViewOf(batch, view, slice), shading);
}

void VolumeTintPass::tint(const std::vector<VolumeDraw>& draws, const CountPlan& plan,
                          const GpuScene& scene, const CasterGroupInSlice& casters) const {
    glDepthMask(GL_FALSE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    forEachDraw(draws, plan, *volumes_, scene, casters,
                [&](const VolumeDraw& draw, const DrawnBatch& batch) {
                    if (draw.shape == VolumeDraw::Shape::sides)
                        glEnable(GL_DEPTH_TEST);
                    else
                        glDisable(GL_DEPTH_TEST);
                    volumes_->draw(draw, batch);
                });
}

} // namespace edgeshade
