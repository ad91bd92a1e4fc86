#include "src/scene/culling_job.hpp"

#include "preprocess/base/spare_time.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "src/scene/receivers.hpp"
#include "src/shadow/culling/kept_records.hpp"
#include "src/shadow/culling/shadowed_casters.hpp"
#include "src/shadow/geometry/light_extent.hpp"
#include "src/shadow/silhouette/light_facings.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// All places of the light in a batch's space.
LightBall ballOf(const Light& light, const glm::dmat4& worldFromBatch) {
    if (light.extent) return ballInObject(regionOf(light), worldFromBatch);
    return {lightInObject(light, worldFromBatch), 0.0f};
}

} // namespace

CullingJob::CullingJob(const LoadedScene& loaded, const Light& light, int mantissaBits,
                       KeptEdges edges)
    : light_(light), mantissaBits_(mantissaBits), edges_(std::move(edges)) {
    kept_.light = light;
    kept_.shadows.resize(loaded.scene.batches.size());
    for (std::size_t i = 0; i < loaded.scene.batches.size(); ++i) {
        const Batch& batch = loaded.scene.batches[i];
        if (!batch.isAnimated() && !loaded.planePairs[i]->caps.empty())
            resting_.push_back({i, loaded.planePairs[i], batch.worldFromBatch});
    }
    if (light.extent) receivers_ = receiversOf(loaded);
}

CullingJob::~CullingJob() {
    givenUp_ = true;
}

void CullingJob::start() {
#ifndef __EMSCRIPTEN__
    thread_ = std::jthread([this] {
        takeSpareTimeAlone();
        finish();
    });
#endif
}

void CullingJob::finish() {
    Stopwatch watch;
    work();
    kept_.milliseconds = 1e3 * watch.lap();
    done_ = true;
}

void CullingJob::work() {
    std::vector<CullingCasters> casters;
    for (const Resting& of : resting_) {
        if (givenUp_) return;
        auto& edges = edges_[of.shadow];
        if (!edges) edges = std::make_shared<const CasterEdges>(casterEdgesOf(*of.shadow));
        CullingCasters& its = casters.emplace_back();
        its.shadow = of.shadow;
        its.placed = {edges, of.worldFromBatch};
        LightFacings(*of.shadow)
            .find(ballOf(light_, of.worldFromBatch), mantissaBits_, its.facings);
    }
    CullingSettings settings;
    settings.receivers = receivers_;
    settings.givenUp = [this] { return givenUp_.load(); };
    const auto gone = shadowedCasters(light_, casters, settings);
    if (givenUp_) return;
    for (std::size_t i = 0; i < gone.size(); ++i) {
        const auto count = static_cast<std::size_t>(std::count(gone[i].begin(), gone[i].end(), 1));
        kept_.casters += gone[i].size();
        kept_.gone += count;
        if (count > 0)
            kept_.shadows[resting_[i].batch] = std::make_shared<const PlanePairShadow>(
                withoutCasters(*resting_[i].shadow, *casters[i].placed.casters, gone[i]));
    }
}

} // namespace edgeshade
