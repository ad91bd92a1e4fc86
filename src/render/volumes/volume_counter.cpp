#include "src/render/volumes/volume_counter.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/volumes/stencil_count.hpp"

namespace edgeshade {
namespace {

const gl::Capabilities& requireInstancing(const RenderSettings& settings,
                                          const gl::Capabilities& capabilities) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' does without.");
    return capabilities;
}

} // namespace

VolumeCounter::VolumeCounter(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : mantissaBits_(capabilities.vertexHighpMantissaBits) {
    const auto& instancing = requireInstancing(settings, capabilities).instancing;
    const auto records = settings.records();
    if (!records) return;
    if (records->volumes == VolumeLayout::adapted) {
        adapted_.emplace(settings.layout, instancing);
        picture_.emplace();
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

PreparedCount VolumeCounter::prepare(const CountTask& task) {
    return adapted_ ? prepareAdapted(task) : preparePublished(task);
}

void VolumeCounter::count(const PreparedCount& prepared, const GpuScene& scene) {
    if (adapted_)
        countAdapted(prepared, scene);
    else
        countPublished(prepared, scene);
}

PreparedCount VolumeCounter::prepareAdapted(const CountTask& task) {
    const Light& light = task.view.lights[task.light].light;
    std::vector<PlacedShadow> casters;
    for (std::size_t i = 0; i < task.scene.batches.size(); ++i) {
        const GpuBatch& batch = task.scene.batches[i];
        if (!batch.hidden)
            casters.push_back({i, task.volumesOf(i).adapted->shadow().get(), batch.worldFromBatch});
    }
    PreparedCount prepared;
    prepared.plan = planLight(casters, task.view, task.slice, light, mantissaBits_);
    prepared.sealed = prepared.plan.sealed();
    prepared.start = prepared.sealed ? 1 : prepared.plan.start();
    if (prepared.sealed) return prepared;
    for (std::size_t i = 0; i < prepared.plan.batches.size(); ++i) {
        const LightPlan::Batch& planned = prepared.plan.batches[i];
        const std::vector<VolumeDraw>& draws = planned.volumes.draws;
        if (draws.empty()) continue;
        const GpuBatch& batch = task.scene.batches[planned.batch];
        const BatchVolumes& volumes = task.volumesOf(planned.batch);
        const auto& shadow = volumes.adapted->shadow();
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        const ProposedRecords* proposed =
            proposals_ ? &proposals_->of(shadow, task.light, lightHere) : nullptr;
        prepared.batches.push_back({.volumes = volumes,
                                    .view = batchViewOf(batch, task.view, task.slice),
                                    .light = lightHere,
                                    .planned = i,
                                    .proposed = proposed});
        prepared.countsByTwo =
            prepared.countsByTwo || mayCountTwice(*shadow, listOf(proposed), draws);
        prepared.vertexRuns += vertexRuns(*shadow, listOf(proposed), draws, task.scene.materials,
                                          light.position.w == 0.0);
    }
    return prepared;
}

void VolumeCounter::countAdapted(const PreparedCount& prepared, const GpuScene& scene) {
    const auto forEachDraw = [&](const auto& use) {
        for (const PreparedCount::Batch& batch : prepared.batches)
            for (const VolumeDraw& draw : prepared.plan.batches[batch.planned].volumes.draws)
                use(batch, draw);
    };
    const auto drawSides = [&](const PreparedCount::Batch& of, const VolumeDraw& draw,
                               Times times) {
        const PlanView& planned = prepared.plan.batches[of.planned].view;
        adapted_->drawSides(*of.volumes.adapted, of.proposed, draw, times, endOf(draw, planned),
                            of.light, of.view.clipFromObject);
        adapted_->drawFannedCaps(*of.volumes.adapted, of.proposed, draw, times, of.light,
                                 of.view.clipFromObject);
    };
    if (prepared.countsByTwo) {
        forEachDraw([&](const PreparedCount::Batch& of, const VolumeDraw& draw) {
            countByOne(draw.zFail(), of.view.mirrored);
            drawSides(of, draw, Times::twice);
        });
        doubleCounts(prepared.start, *picture_);
    }
    forEachDraw([&](const PreparedCount::Batch& of, const VolumeDraw& draw) {
        countByOne(draw.zFail(), of.view.mirrored);
        drawSides(of, draw, Times::once);
        adapted_->drawCaps(*of.volumes.adapted, of.proposed, draw, scene.materials, scene.textures,
                           of.light, of.view.clipFromObject);
    });
}

PreparedCount VolumeCounter::preparePublished(const CountTask& task) const {
    PreparedCount prepared;
    for (std::size_t i = 0; i < task.scene.batches.size(); ++i) {
        const GpuBatch& batch = task.scene.batches[i];
        if (batch.hidden) continue;
        const BatchVolumes& volumes = task.volumesOf(i);
        prepared.batches.push_back(
            {.volumes = volumes,
             .view = batchViewOf(batch, task.view, task.slice),
             .light = lightInObject(task.view.lights[task.light].light, batch.worldFromBatch),
             .nearDiscard = task.view.nearestDepths[i] <= task.slice.near});
        prepared.vertexRuns += volumes.published->vertexRuns(task.scene.materials);
    }
    return prepared;
}

void VolumeCounter::countPublished(const PreparedCount& prepared, const GpuScene& scene) {
    for (const PreparedCount::Batch& of : prepared.batches) {
        countByOne(true, of.view.mirrored);
        sides_->draw(*of.volumes.published, of.light, of.view.clipFromObject);
        caps_->draw(*of.volumes.published, scene.materials, scene.textures, of.light,
                    of.view.clipFromObject, of.nearDiscard);
    }
}

int PreparedCount::cleared() const {
    return countsByTwo ? halvedStart(start) : start;
}

} // namespace edgeshade
