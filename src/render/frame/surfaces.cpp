// Renderer: opaque surfaces, in each form that a frame needs.

#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/pass_state.hpp"
#include "src/shadow/view/light_reach.hpp"

#include <GLES2/gl2.h>
#include <limits>

namespace edgeshade {

std::size_t Renderer::drawSurfaces(const GpuScene& scene, const FrameView& view,
                                   const DepthSlice& slice, const SurfaceShading& shading) {
    std::size_t runs = 0;
    const ViewPlanes planes = viewPlanes(view, slice, glm::dmat4(1.0));
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden || (batch.ground && !view.ground) || isOutOfView(batch, planes)) continue;
        const BatchView batchView = surfaceViewOf(scene, batch, view, slice, shading);
        runs += surfaces_.draw(scene, batch, batchView, shading);
    }
    return runs;
}

void Renderer::drawNearness(const GpuScene& scene, const FrameView& view) {
    const gl::ScissorScope cut(view.part);
    PlaneSpace space{.near = static_cast<float>(view.near())};
    if (view.frustum.orthographic)
        space.depthRange = static_cast<float>(view.farPlane - view.near());
    glViewport(0, 0, view.width, view.height);
    set(passes::surfaces);
    for (const GLenum off : {GL_CULL_FACE, GL_DITHER})
        glDisable(off);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const DepthSlice& slice : view.slices) {
        glClear(GL_DEPTH_BUFFER_BIT);
        SurfaceShading shading;
        shading.nearness = &space;
        shading.farthest = static_cast<float>(slice.far * sliceOverlap);
        drawSurfaces(scene, view, slice, shading);
    }
    glEnable(GL_DITHER);
}

/// Draws depth and planes of visible surfaces, for the masks of all lights.
void Renderer::drawCoarseSurfaces(const SlicePass& pass) {
    const StageScope stage(pass.clock, FrameStage::counting);
    const gl::FramebufferKeeper keeper;
    coarse_->bindSurfaces();
    const gl::ScissorScope cut(scaledReach(pass.plan.reach, pass.view, coarse_->size()));
    set(passes::surfaces);
    glDisable(GL_DITHER); // the bytes are not colours
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const PlaneSpace planes = coarse_->space(pass.view, pass.slice);
    SurfaceShading shading = shadingOf(pass, {});
    shading.planes = &planes;
    vertexRuns_ += drawSurfaces(pass.scene, pass.view, pass.slice, shading);
    glEnable(GL_DITHER);
    glViewport(0, 0, pass.view.width, pass.view.height);
}

void Renderer::restoreAlpha(const GpuScene& scene, const FrameView& view) {
    mark_.clear();
    if (!view.mask) return;
    // A mask's alpha says where surfaces are.
    set(passes::alpha);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    SurfaceShading shading;
    shading.mask = true;
    const DepthSlice whole{view.near(), std::numeric_limits<double>::infinity()};
    drawSurfaces(scene, view, whole, shading);
}

} // namespace edgeshade
