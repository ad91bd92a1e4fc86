#include "src/render/volume_counter.hpp"

#include "preprocess/error.hpp"
#include "src/render/batch_view.hpp"
#include "src/render/light_plan.hpp"
#include "src/render/stencil_count.hpp"

namespace edgeshade {
namespace {

const gl::Capabilities& requireInstancing(const RenderSettings& settings,
                                          const gl::Capabilities& capabilities) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' does without.");
    return capabilities;
}

/// What of a batch is counted.
struct CountedBatch {
    const GpuBatch& batch;
    const AdaptedBuffers& buffers;
    const LightPlan::Batch& plan;
    const ProposedRecords* proposed;
    BatchView view;
    glm::vec4 light; ///< in its space
};

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
    if (plan.sealed()) {
        clearStencil(1);
        return {0, true};
    }
    std::vector<CountedBatch> counted;
    bool twice = false;
    std::size_t runs = 0;
    for (const LightPlan::Batch& planned : plan.batches) {
        const std::vector<VolumeDraw>& draws = planned.volumes.draws;
        if (draws.empty()) continue;
        const GpuBatch& batch = task.scene.batches[planned.batch];
        const AdaptedBuffers& buffers = *task.volumesOf(planned.batch).adapted;
        const AdaptedShadow& shadow = *buffers.shadow();
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        const ProposedRecords* proposed =
            proposals_ ? &proposals_->of(buffers.shadow(), task.light, lightHere) : nullptr;
        counted.push_back({batch, buffers, planned, proposed,
                           batchViewOf(batch, task.view, task.slice), lightHere});
        twice = twice || mayCountTwice(shadow, proposed, draws);
        runs += vertexRuns(shadow, proposed, draws, task.scene.materials, light.position.w == 0.0);
    }
    const auto drawSides = [&](const CountedBatch& of, const VolumeDraw& draw, Times times) {
        adapted_->drawSides(of.buffers, of.proposed, draw, times, endOf(draw, of.plan.view),
                            of.light, of.view.clipFromObject);
    };
    if (twice)
        countByTwo(plan.start(), [&](bool up) {
            for (const CountedBatch& of : counted)
                for (const VolumeDraw& draw : of.plan.volumes.draws) {
                    countStepOfTwo(up, draw.zFail(), of.view.mirrored);
                    drawSides(of, draw, Times::twice);
                }
        });
    else
        clearStencil(plan.start());
    for (const CountedBatch& of : counted)
        for (const VolumeDraw& draw : of.plan.volumes.draws) {
            countByOne(draw.zFail(), of.view.mirrored);
            drawSides(of, draw, Times::once);
            adapted_->drawCaps(of.buffers, of.proposed, draw, task.scene.materials,
                               task.scene.textures, of.light, of.view.clipFromObject);
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
        countByOne(true, batchView.mirrored);
        sides_->draw(shadow, lightHere, batchView.clipFromObject);
        const bool nearDiscard = task.view.nearestDepths[i] <= task.slice.near;
        caps_->draw(shadow, task.scene.materials, task.scene.textures, lightHere,
                    batchView.clipFromObject, nearDiscard);
        runs += shadow.vertexRuns(task.scene.materials);
    }
    return {runs, false};
}

} // namespace edgeshade
