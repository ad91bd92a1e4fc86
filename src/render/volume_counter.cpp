#include "src/render/volume_counter.hpp"

#include "preprocess/error.hpp"
#include "src/render/batch_view.hpp"
#include "src/render/light_plan.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

const gl::Capabilities& requireInstancing(const RenderSettings& settings,
                                          const gl::Capabilities& capabilities) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' does without.");
    return capabilities;
}

/// Counts volumes that begin before a surface and end behind it: by what of them is behind it
/// (z-fail), or before it (z-pass). Volumes' triangles are seen counter-clockwise from outside. A
/// mirroring transform turns every winding over.
void countInStencil(bool zFail, bool mirrored) {
    const GLenum front = mirrored ? GL_BACK : GL_FRONT;
    const GLenum back = mirrored ? GL_FRONT : GL_BACK;
    if (zFail) {
        glStencilOpSeparate(front, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
        glStencilOpSeparate(back, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    } else {
        glStencilOpSeparate(front, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
        glStencilOpSeparate(back, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    }
}

void clearStencil(int count) {
    glClearStencil(count & 0xFF); // counts wrap
    glClear(GL_STENCIL_BUFFER_BIT);
}

} // namespace

VolumeCounter::VolumeCounter(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : mantissaBits_(capabilities.vertexHighpMantissaBits) {
    const auto& instancing = requireInstancing(settings, capabilities).instancing;
    const auto records = settings.records();
    if (!records) return;
    if (records->volumes == VolumeLayout::adapted) {
        adapted_.emplace(settings.layout, instancing);
        if (settings.silhouette == SilhouetteChoice::proposed)
            proposals_.emplace(settings.layout, mantissaBits_);
    } else {
        sides_.emplace(settings.multiplicity, settings.layout, instancing);
        caps_.emplace(settings.multiplicity, settings.layout, instancing);
    }
}

void VolumeCounter::beginFrame(const GpuScene& scene) {
    if (proposals_) proposals_->beginFrame(scene.identity);
}

VolumeCount VolumeCounter::count(const CountTask& task) {
    return adapted_ ? countAdapted(task) : countPublished(task);
}

VolumeCount VolumeCounter::countAdapted(const CountTask& task) {
    const Light& light = task.view.lights[task.light];
    std::vector<PlacedShadow> casters;
    for (std::size_t i = 0; i < task.scene.batches.size(); ++i) {
        const GpuBatch& batch = task.scene.batches[i];
        if (!batch.hidden)
            casters.push_back({i, task.volumesOf(i).adapted->shadow().get(), batch.worldFromBatch});
    }
    const LightPlan plan = planLight(casters, task.view, task.slice, light, mantissaBits_);
    clearStencil(plan.sealed() ? 1 : plan.start());
    if (plan.sealed()) return {0, true};
    std::size_t runs = 0;
    for (const auto& [index, planned, volumes] : plan.batches) {
        const GpuBatch& batch = task.scene.batches[index];
        const AdaptedBuffers& buffers = *task.volumesOf(index).adapted;
        const BatchView batchView = batchViewOf(batch, task.view, task.slice);
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        const ProposedRecords* proposed = nullptr;
        if (proposals_ && !volumes.draws.empty())
            proposed = &proposals_->of(buffers.shadow(), task.light, lightHere);
        for (const VolumeDraw& draw : volumes.draws) {
            countInStencil(draw.zFail(), batchView.mirrored);
            adapted_->drawSides(buffers, proposed, draw, endOf(draw, planned), lightHere,
                                batchView.clipFromObject);
            adapted_->drawCaps(buffers, proposed, draw, task.scene.materials, task.scene.textures,
                               lightHere, batchView.clipFromObject);
        }
        runs += vertexRuns(*buffers.shadow(), proposed, volumes.draws, task.scene.materials,
                           light.position.w == 0.0);
    }
    return {runs, false};
}

VolumeCount VolumeCounter::countPublished(const CountTask& task) {
    const Light& light = task.view.lights[task.light];
    clearStencil(0);
    std::size_t runs = 0;
    for (std::size_t i = 0; i < task.scene.batches.size(); ++i) {
        const GpuBatch& batch = task.scene.batches[i];
        if (batch.hidden) continue;
        const ShadowBuffers& shadow = *task.volumesOf(i).published;
        const BatchView batchView = batchViewOf(batch, task.view, task.slice);
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        countInStencil(true, batchView.mirrored);
        sides_->draw(shadow, lightHere, batchView.clipFromObject);
        const bool nearDiscard = task.view.nearestDepths[i] <= task.slice.near;
        caps_->draw(shadow, task.scene.materials, task.scene.textures, lightHere,
                    batchView.clipFromObject, nearDiscard);
        runs += shadow.vertexRuns(task.scene.materials);
    }
    return {runs, false};
}

} // namespace edgeshade
