#include "src/scene/primitive_maps.hpp"

#include "src/shadow/silhouette/count_silhouettes.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

std::size_t silhouettesOf(const LoadedScene& loaded, const Light& light) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        count +=
            countSilhouettes(*loaded.planePairs[i],
                             glm::inverse(loaded.scene.batches[i].worldFromBatch) * light.position);
    return count;
}

} // namespace

std::string primitiveMapObstacle(const LoadedScene& loaded, const gl::Capabilities& capabilities) {
    if (!gl::hasFloatTables(capabilities)) return "the GL looks up no floats";
    if (loaded.cutoutsCast && capabilities.textureUnits < 6)
        return "the GL has too few textures for cutouts";
    const auto simplified = [](const Batch& batch) { return batch.simplifiedCasters.has_value(); };
    const auto& batches = loaded.scene.batches;
    if (std::any_of(batches.begin(), batches.end(), simplified)) return "casters are simplified";
    if (!batches.empty() && std::all_of(batches.begin(), batches.end(),
                                        [](const Batch& batch) { return batch.isAnimated(); }))
        return "all casters are animated";
    for (const auto& shadow : loaded.planePairs)
        for (const ShadowCluster& cluster : shadow->clusters)
            if (cluster.alphaTested) return "some casters are alpha-tested";
    return {};
}

bool mayHaveMaps(const LoadedScene& loaded, MapChoice choice,
                 const gl::Capabilities& capabilities) {
    if (!primitiveMapObstacle(loaded, capabilities).empty()) return false;
    std::size_t records = 0;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        if (!loaded.scene.batches[i].isAnimated())
            records += loaded.planePairs[i]->pairs.size() + loaded.planePairs[i]->singles.size();
    return choice == MapChoice::all || records > fewSilhouettes || loaded.cutoutsCast;
}

const PrimitiveMapState* PrimitiveMaps::of(const Light& light) const {
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const Kept& kept) { return kept.light == light.position; });
    return found == kept_.end() ? nullptr : &found->state;
}

void PrimitiveMaps::clear() {
    job_.reset();
    kept_.clear();
}

std::size_t PrimitiveMaps::bytes() const {
    std::size_t total = 0;
    for (const Kept& kept : kept_)
        if (kept.state.map) total += kept.state.map->bytes();
    return total + (cutouts_ ? cutouts_->bytes : 0);
}

void PrimitiveMaps::keepOnly(const std::vector<Light>& lights) {
    const auto isGone = [&](const glm::dvec4& of) {
        return std::none_of(lights.begin(), lights.end(),
                            [&](const Light& light) { return light.position == of; });
    };
    std::erase_if(kept_, [&](const Kept& kept) { return isGone(kept.light); });
    if (job_ && isGone(job_->light())) job_.reset();
}

bool PrimitiveMaps::needsJob(const LoadedScene& loaded, const Light& light, MapChoice choice,
                             const gl::Capabilities& capabilities) {
    if (of(light)) return false;
    std::string why = primitiveMapObstacle(loaded, capabilities);
    if (why.empty() && choice == MapChoice::thatPay && !loaded.cutoutsCast)
        if (const std::size_t count = silhouettesOf(loaded, light); count <= fewSilhouettes)
            why = "volumes of " + std::to_string(count) + " silhouette edges cost less";
    if (why.empty()) return true;
    kept_.push_back({light.position, {nullptr, why, 0.0}});
    return false;
}

void PrimitiveMaps::take(const PrimitiveMapJob& job, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    edges_ = job.edges();
    PrimitiveMapState state{nullptr, "at rest", job.milliseconds()};
    if (job.map())
        state.map = std::make_shared<const GpuPrimitiveMap>(
            uploadPrimitiveMap(*job.map(), job.triangles(), cutouts_, capabilities));
    else if (job.isTooFar())
        state.why = "the light is too far from its casters for a primitive map";
    else
        state.why = "a primitive map would take more than " + std::to_string(settings.mostBytes) +
                    " bytes, or minutes";
    kept_.push_back({job.light(), std::move(state)});
}

PrimitiveMapSettings PrimitiveMaps::completed(const LoadedScene& loaded,
                                              PrimitiveMapSettings settings,
                                              const gl::Capabilities& capabilities) {
    if (!loaded.cutoutsCast) return settings;
    if (!cutouts_) {
        const CutoutAtlas atlas = cutoutAtlasOf(loaded, capabilities.largestTexture);
        textures_ = atlas.textures;
        cutouts_ = std::make_shared<const AlphaTexture>(
            uploadAlpha(atlas.alpha, atlas.width, atlas.height));
    }
    settings.cutouts = textures_;
    return settings;
}

void PrimitiveMaps::make(const LoadedScene& loaded, const std::vector<Light>& lights,
                         MapChoice choice, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    keepOnly(lights);
    for (const Light& light : lights) {
        if (!needsJob(loaded, light, choice, capabilities)) continue;
        PrimitiveMapJob job(loaded, light, completed(loaded, settings, capabilities), edges_);
        job.finish();
        take(job, settings, capabilities);
    }
}

bool PrimitiveMaps::advance(const LoadedScene& loaded, const std::vector<Light>& lights,
                            MapChoice choice, const PrimitiveMapSettings& settings,
                            const gl::Capabilities& capabilities, double milliseconds) {
    keepOnly(lights);
    if (!job_)
        for (const Light& light : lights) {
            if (!needsJob(loaded, light, choice, capabilities)) continue;
            job_ = std::make_unique<PrimitiveMapJob>(
                loaded, light, completed(loaded, settings, capabilities), edges_);
            job_->start();
            break;
        }
    if (!job_ || !job_->advance(milliseconds)) return false;
    const auto job = std::move(job_);
    take(*job, settings, capabilities);
    return true;
}

} // namespace edgeshade
