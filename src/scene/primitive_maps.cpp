#include "src/scene/primitive_maps.hpp"

#include "src/shadow/silhouette/count_silhouettes.hpp"

#include <algorithm>
#include <cmath>

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

/// Whether some surfaces are in no primitive map.
bool othersReceive(const LoadedScene& loaded) {
    const Scene& scene = loaded.scene;
    return std::any_of(scene.batches.begin(), scene.batches.end(), [&](const Batch& batch) {
        if (batch.ground) return loaded.showsGround;
        return batch.isAnimated() ||
               std::any_of(batch.geometry->groups.begin(), batch.geometry->groups.end(),
                           [&](const SurfaceGroup& g) {
                               return !scene.materials[g.material].casts(false);
                           });
    });
}

} // namespace

std::string primitiveMapObstacle(const LoadedScene& loaded, const gl::Capabilities& capabilities) {
    if (!gl::hasFloatTables(capabilities)) return "the GL looks up no floats";
    if (loaded.cutoutsCast && capabilities.textureUnits < 6)
        return "the GL has too few textures for cutouts";
    const auto simplified = [](const Batch& batch) {
        return batch.geometry->simplifiedCasters.has_value();
    };
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

std::string extendedMapObstacle(const LoadedScene& loaded, const Light& light,
                                const gl::Capabilities& capabilities) {
    constexpr int mostUniforms = 64; // vectors; the places take 17
    const std::string why = primitiveMapObstacle(loaded, capabilities);
    if (!why.empty()) return why;
    if (capabilities.fragmentUniformVectors < mostUniforms)
        return "the GL has too few uniforms for a light's places";
    if (light.hasRange()) return "a light with an extent has a range";
    if (light.isSpot()) return "a light with an extent is a spot";
    if (loaded.cutoutsCast) return "a light with an extent shines on cutouts";
    const auto& batches = loaded.scene.batches;
    if (std::any_of(batches.begin(), batches.end(),
                    [](const Batch& batch) { return batch.isAnimated(); }))
        return "a light with an extent shines on what moves";
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
                                    [&](const Kept& kept) { return kept.isOf(light); });
    return found == kept_.end() ? nullptr : &found->state;
}

void PrimitiveMaps::clear() {
    job_.reset();
    giveUp();
    kept_.clear();
}

void PrimitiveMaps::giveUp() {
    if (asked_) worker_->giveUp();
    asked_.reset();
}

std::size_t PrimitiveMaps::bytes() const {
    std::size_t total = 0;
    for (const Kept& kept : kept_)
        if (kept.state.map) total += kept.state.map->bytes();
    return total + (cutouts_ ? cutouts_->bytes : 0);
}

void PrimitiveMaps::keepOnly(const std::vector<Light>& lights) {
    const auto isGone = [&](const glm::dvec4& of, const std::optional<LightExtent>& extent) {
        return std::none_of(lights.begin(), lights.end(), [&](const Light& light) {
            return light.position == of && light.extent == extent;
        });
    };
    std::erase_if(kept_, [&](const Kept& kept) { return isGone(kept.light, kept.extent); });
    if (job_ && isGone(job_->light().position, job_->light().extent)) job_.reset();
    if (asked_ && isGone(asked_->position, asked_->extent)) giveUp();
}

bool PrimitiveMaps::needsJob(const LoadedScene& loaded, const Light& light, MapChoice choice,
                             const gl::Capabilities& capabilities) {
    if (of(light)) return false;
    std::string why = light.extent ? extendedMapObstacle(loaded, light, capabilities)
                                   : primitiveMapObstacle(loaded, capabilities);
    if (why.empty() && choice == MapChoice::thatPay && !loaded.cutoutsCast && !light.extent)
        if (const std::size_t count = silhouettesOf(loaded, light); count <= fewSilhouettes)
            why = "volumes of " + std::to_string(count) + " silhouette edges cost less";
    if (why.empty()) return true;
    kept_.push_back({light.position, light.extent, {nullptr, why, 0.0}});
    return false;
}

/// Batches that whoever built it didn't know, the ground, have no sided triangles.
void PrimitiveMaps::take(const BuiltPrimitiveMap& built, std::size_t batches, MapChoice choice,
                         const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    PrimitiveMapState state{nullptr, "at rest", built.milliseconds};
    const std::string refusal = refusalOf(built.map, built.tooFar, settings.mostBytes);
    if (!refusal.empty()) {
        state.why = refusal;
    } else if (choice == MapChoice::thatPay && built.map->meanList > longLists) {
        state.why = "volumes cost less than lists of " +
                    std::to_string(std::lround(built.map->meanList)) + " triangles";
    } else {
        auto map = std::make_shared<GpuPrimitiveMap>(
            uploadPrimitiveMap(*built.map, built.triangles, cutouts_, capabilities));
        map->sided.resize(std::max(map->sided.size(), batches));
        state.map = std::move(map);
    }
    kept_.push_back({built.light, built.extent, std::move(state)});
}

PrimitiveMapTask PrimitiveMaps::taskOf(const LoadedScene& loaded, const Light& light,
                                       PrimitiveMapSettings settings,
                                       const gl::Capabilities& capabilities) {
    settings.othersReceive = othersReceive(loaded);
    if (light.extent) {
        // What lies between a texel and all of the light shrinks little with the texel.
        settings.size = std::max(4, settings.size / 2);
        settings.mostSplits = 0;
        for (const Batch& batch : loaded.scene.batches)
            if (!batch.ground || loaded.showsGround)
                for (const glm::vec3& position : batch.geometry->positions)
                    settings.receivers.add(
                        glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    }
    if (!loaded.cutoutsCast) return {light, std::move(settings)};
    if (!cutouts_) {
        const CutoutAtlas atlas = cutoutAtlasOf(loaded, capabilities.largestTexture);
        textures_ = atlas.textures;
        cutouts_ = std::make_shared<const AlphaTexture>(
            uploadAlpha(atlas.alpha, atlas.width, atlas.height));
    }
    settings.cutouts = textures_;
    return {light, std::move(settings)};
}

std::optional<PrimitiveMapTask> PrimitiveMaps::nextTask(const LoadedScene& loaded,
                                                        const std::vector<Light>& lights,
                                                        MapChoice choice,
                                                        const PrimitiveMapSettings& settings,
                                                        const gl::Capabilities& capabilities) {
    for (const Light& light : lights)
        if (needsJob(loaded, light, choice, capabilities))
            return taskOf(loaded, light, settings, capabilities);
    return std::nullopt;
}

void PrimitiveMaps::make(const LoadedScene& loaded, const std::vector<Light>& lights,
                         MapChoice choice, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    keepOnly(lights);
    while (const auto task = nextTask(loaded, lights, choice, settings, capabilities)) {
        PrimitiveMapJob job(loaded, *task, edges_);
        job.finish();
        edges_ = job.edges();
        take(job.built(), loaded.scene.batches.size(), choice, settings, capabilities);
    }
}

bool PrimitiveMaps::advance(const LoadedScene& loaded, const std::vector<Light>& lights,
                            MapChoice choice, const PrimitiveMapSettings& settings,
                            const gl::Capabilities& capabilities, double milliseconds) {
    keepOnly(lights);
    const bool helped = worker_ && worker_->works();
    if (!helped) asked_.reset();
    if (!job_ && !(helped && asked_))
        if (const auto task = nextTask(loaded, lights, choice, settings, capabilities)) {
            if (helped) {
                worker_->ask(*task);
                asked_ = task->light;
            } else {
                job_ = std::make_unique<PrimitiveMapJob>(loaded, *task, edges_);
                job_->start();
            }
        }
    const std::size_t batches = loaded.scene.batches.size();
    if (helped && asked_) {
        const auto built = worker_->take();
        if (!built) return false;
        asked_.reset();
        take(*built, batches, choice, settings, capabilities);
        return true;
    }
    if (!job_ || !job_->advance(milliseconds)) return false;
    const auto job = std::move(job_);
    edges_ = job->edges();
    take(job->built(), batches, choice, settings, capabilities);
    return true;
}

} // namespace edgeshade
