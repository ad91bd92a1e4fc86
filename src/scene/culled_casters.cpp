#include "src/scene/culled_casters.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "src/shadow/culling/kept_records.hpp"
#include "src/shadow/culling/shadowed_casters.hpp"
#include "src/shadow/silhouette/light_facings.hpp"

#include <algorithm>
#include <map>

namespace edgeshade {
namespace {

/// The batches that rest, with all that tells which of their casters may go.
struct Resting {
    std::vector<std::size_t> batches; ///< by index in the scene
    std::vector<CullingCasters> casters;
};

Resting restingOf(const LoadedScene& loaded, const Light& light, int mantissaBits) {
    Resting resting;
    std::map<const PlanePairShadow*, std::shared_ptr<const CasterEdges>> edges;
    for (std::size_t i = 0; i < loaded.scene.batches.size(); ++i) {
        const Batch& batch = loaded.scene.batches[i];
        const auto& shadow = loaded.planePairs[i];
        if (batch.isAnimated() || shadow->caps.empty()) continue;
        auto& of = edges[shadow.get()];
        if (!of) of = std::make_shared<const CasterEdges>(casterEdgesOf(*shadow));
        CullingCasters& casters = resting.casters.emplace_back();
        casters.shadow = shadow;
        casters.placed = {of, batch.worldFromBatch};
        LightFacings(*shadow).find({lightInObject(light, batch.worldFromBatch), 0.0f}, mantissaBits,
                                   casters.facings);
        resting.batches.push_back(i);
    }
    return resting;
}

CulledCasters::Kept culled(const LoadedScene& loaded, const Light& light, SidesLayout layout,
                           int mantissaBits) {
    Stopwatch watch;
    CulledCasters::Kept kept;
    kept.light = light.position;
    kept.volumes.resize(loaded.scene.batches.size());
    const Resting resting = restingOf(loaded, light, mantissaBits);
    const auto gone = shadowedCasters(light, resting.casters);
    for (std::size_t i = 0; i < gone.size(); ++i) {
        kept.casters += gone[i].size();
        const auto count = static_cast<std::size_t>(std::count(gone[i].begin(), gone[i].end(), 1));
        if (count == 0) continue;
        kept.gone += count;
        const CullingCasters& of = resting.casters[i];
        kept.volumes[resting.batches[i]].planePairs = std::make_shared<PlanePairBuffers>(
            std::make_shared<const PlanePairShadow>(
                withoutCasters(*of.shadow, *of.placed.casters, gone[i])),
            std::vector<glm::vec4>(), layout);
    }
    kept.buildMs = 1e3 * watch.lap();
    return kept;
}

} // namespace

bool CulledCasters::suits(const FrameLight& light) {
    return light.drawn && light.shadowed && light.atRest && !light.light.extent &&
           light.points.empty() && !light.among && light.groupCount() == 1;
}

void CulledCasters::make(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                         SidesLayout layout, int mantissaBits) {
    std::vector<Kept> kept;
    for (const FrameLight& of : lights) {
        const auto isOf = [&](const Kept& entry) { return entry.light == of.light.position; };
        if (!suits(of) || std::any_of(kept.begin(), kept.end(), isOf)) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), isOf);
        kept.push_back(found != kept_.end() ? std::move(*found)
                                            : culled(loaded, of.light, layout, mantissaBits));
    }
    kept_ = std::move(kept);
}

const CulledCasters::Kept* CulledCasters::of(const FrameLight& light) const {
    if (!suits(light)) return nullptr;
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& entry) {
        return entry.light == light.light.position;
    });
    return found != kept_.end() ? &*found : nullptr;
}

BatchVolumes* CulledCasters::of(const FrameLight& light, std::size_t batch) {
    const Kept* kept = of(light);
    if (!kept || !kept->volumes[batch].planePairs) return nullptr;
    return &kept_[static_cast<std::size_t>(kept - kept_.data())].volumes[batch];
}

const BatchVolumes* CulledCasters::of(const FrameLight& light, std::size_t batch) const {
    const Kept* kept = of(light);
    return kept && kept->volumes[batch].planePairs ? &kept->volumes[batch] : nullptr;
}

std::size_t CulledCasters::sideBytes() const {
    std::size_t total = 0;
    for (const Kept& kept : kept_)
        for (const BatchVolumes& volumes : kept.volumes)
            total += volumes.sideBytes();
    return total;
}

std::size_t CulledCasters::capBytes() const {
    std::size_t total = 0;
    for (const Kept& kept : kept_)
        for (const BatchVolumes& volumes : kept.volumes)
            total += volumes.capBytes();
    return total;
}

} // namespace edgeshade
