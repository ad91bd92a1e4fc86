#include "src/scene/primitive_maps.hpp"

#include "src/scene/receivers.hpp"
#include "src/shadow/silhouette/count_silhouettes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edgeshade {
namespace {

constexpr double moreWouldNotHelp = std::numeric_limits<double>::infinity();
constexpr char noRoom[] = "other lights' primitive maps leave no room";

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

std::vector<PrimitiveMaps::Kept>::const_iterator
PrimitiveMaps::firstAt(const glm::dvec4& place) const {
    const auto isBefore = [](const Kept& kept, const glm::dvec4& of) {
        const glm::dvec4& at = kept.light.position;
        return std::tie(at.x, at.y, at.z, at.w) < std::tie(of.x, of.y, of.z, of.w);
    };
    return std::lower_bound(kept_.begin(), kept_.end(), place, isBefore);
}

std::size_t PrimitiveMaps::placeOf(const Light& light) const {
    auto at = firstAt(light.position);
    while (at != kept_.end() && !castAlike(at->light, light))
        at = at->light.position == light.position ? at + 1 : kept_.end();
    return static_cast<std::size_t>(at - kept_.begin());
}

void PrimitiveMaps::keep(const Light& light, PrimitiveMapState state, double room) {
    kept_.insert(firstAt(light.position), {light, std::move(state), room, false});
}

const PrimitiveMapState* PrimitiveMaps::of(const Light& light) const {
    const std::size_t place = placeOf(light);
    return place == kept_.size() ? nullptr : &kept_[place].state;
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

void PrimitiveMaps::keepOnly(const MapDemand& demand) {
    if (demand.castersReceive != castersReceive_) clear();
    castersReceive_ = demand.castersReceive;
    for (Kept& kept : kept_)
        kept.seen = false;
    bool job = false, asked = false;
    for (const Light& light : demand.lights) {
        if (const std::size_t place = placeOf(light); place < kept_.size())
            kept_[place].seen = true;
        job = job || (job_ && castAlike(job_->light(), light));
        asked = asked || (asked_ && castAlike(*asked_, light));
    }
    std::erase_if(kept_, [](const Kept& kept) { return !kept.seen; });
    if (!job) job_.reset();
    if (!asked) giveUp();
}

void PrimitiveMaps::keepWhatFits(const MapDemand& demand, std::size_t mostBytes) {
    for (Kept& kept : kept_)
        kept.seen = false;
    std::size_t taken = cutouts_ ? cutouts_->bytes : 0;
    for (const Light& light : demand.lights) {
        const std::size_t place = placeOf(light);
        if (place == kept_.size() || kept_[place].seen || !kept_[place].state.map) continue;
        const std::size_t bytes = kept_[place].state.map->bytes();
        if (taken + bytes > mostBytes) {
            kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(place));
            continue;
        }
        taken += bytes;
        kept_[place].seen = true;
    }
}

bool PrimitiveMaps::needsJob(const LoadedScene& loaded, const Light& light, MapChoice choice,
                             const gl::Capabilities& capabilities, std::size_t room) {
    if (const std::size_t place = placeOf(light); place < kept_.size()) {
        const Kept& kept = kept_[place];
        const auto enough = std::max(2.0 * kept.room, static_cast<double>(leastMapBytes));
        if (kept.state.map || static_cast<double>(room) < enough) return false;
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(place));
    }
    std::string why = light.extent ? extendedMapObstacle(loaded, light, capabilities)
                                   : primitiveMapObstacle(loaded, capabilities);
    if (why.empty() && choice == MapChoice::thatPay && !loaded.cutoutsCast && !light.extent)
        if (const std::size_t count = silhouettesOf(loaded, light); count <= fewSilhouettes)
            why = "volumes of " + std::to_string(count) + " silhouette edges cost less";
    if (!why.empty()) {
        keep(light, {nullptr, why, 0.0}, moreWouldNotHelp);
        return false;
    }
    if (room >= leastMapBytes) return true;
    keep(light, {nullptr, noRoom, 0.0}, static_cast<double>(room));
    return false;
}

/// Batches that whoever built it didn't know, the ground, have no sided triangles.
void PrimitiveMaps::take(const BuiltPrimitiveMap& built, std::size_t batches,
                         const MapDemand& demand, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    PrimitiveMapState state{nullptr, "at rest", built.milliseconds};
    double room = moreWouldNotHelp;
    const std::string refusal =
        refusalOf({built.map.has_value(), built.tooFar, built.tooLong, built.mostBytes});
    if (!refusal.empty()) {
        state.why = refusal;
        if (!built.tooFar && built.tooLong == 0 && !built.map)
            room = static_cast<double>(built.mostBytes);
    } else if (demand.choice == MapChoice::thatPay && built.map->meanList > longLists) {
        state.why = "volumes cost less than lists of " +
                    std::to_string(std::lround(built.map->meanList)) + " triangles";
    } else {
        auto map = std::make_shared<GpuPrimitiveMap>(
            uploadPrimitiveMap(*built.map, built.triangles, cutouts_, capabilities));
        map->sided.resize(std::max(map->sided.size(), batches));
        state.map = std::move(map);
    }
    keep(built.light, std::move(state), room);
    keepWhatFits(demand, settings.mostBytes);
    if (!of(built.light)) // others came to matter more while it was built
        keep(built.light, {nullptr, noRoom, built.milliseconds},
             static_cast<double>(built.mostBytes));
}

PrimitiveMapTask PrimitiveMaps::taskOf(const LoadedScene& loaded, const Light& light,
                                       PrimitiveMapSettings settings,
                                       const gl::Capabilities& capabilities) {
    settings.othersReceive = othersReceive(loaded);
    if (light.extent) {
        // What lies between a texel and all of the light shrinks little with the texel.
        settings.size = std::max(4, settings.size / 2);
        settings.mostSplits = 0;
        settings.receivers = receiversOf(loaded);
    }
    if (!loaded.cutoutsCast) return {light, castersReceive_, std::move(settings)};
    if (!cutouts_) {
        const CutoutAtlas atlas = cutoutAtlasOf(loaded, capabilities.largestTexture);
        textures_ = atlas.textures;
        cutouts_ = std::make_shared<const AlphaTexture>(
            uploadAlpha(atlas.alpha, atlas.width, atlas.height));
    }
    settings.cutouts = textures_;
    return {light, castersReceive_, std::move(settings)};
}

std::optional<PrimitiveMapTask> PrimitiveMaps::nextTask(const LoadedScene& loaded,
                                                        const MapDemand& demand,
                                                        const PrimitiveMapSettings& settings,
                                                        const gl::Capabilities& capabilities) {
    std::size_t left = settings.mostBytes;
    const auto take = [&](std::size_t bytes) { left -= std::min(left, bytes); };
    if (cutouts_) take(cutouts_->bytes);
    for (std::size_t i = 0; i < demand.wanted; ++i) {
        const Light& light = demand.lights[i];
        if (needsJob(loaded, light, demand.choice, capabilities, left / 2)) {
            PrimitiveMapSettings its = settings;
            its.mostBytes = left / 2;
            return taskOf(loaded, light, std::move(its), capabilities);
        }
        const PrimitiveMapState* state = of(light);
        if (state->map) take(state->map->bytes());
    }
    return std::nullopt;
}

void PrimitiveMaps::make(const LoadedScene& loaded, const MapDemand& demand,
                         const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    keepOnly(demand);
    while (const auto task = nextTask(loaded, demand, settings, capabilities)) {
        PrimitiveMapJob job(loaded, *task, edges_);
        job.finish();
        edges_ = job.edges();
        take(job.built(), loaded.scene.batches.size(), demand, settings, capabilities);
    }
}

bool PrimitiveMaps::advance(const LoadedScene& loaded, const MapDemand& demand,
                            const PrimitiveMapSettings& settings,
                            const gl::Capabilities& capabilities, double milliseconds) {
    keepOnly(demand);
    const bool helped = worker_ && worker_->works();
    if (!helped) asked_.reset();
    if (!job_ && !(helped && asked_))
        if (const auto task = nextTask(loaded, demand, settings, capabilities)) {
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
        take(*built, batches, demand, settings, capabilities);
        return true;
    }
    if (!job_ || !job_->advance(milliseconds)) return false;
    const auto job = std::move(job_);
    edges_ = job->edges();
    take(job->built(), batches, demand, settings, capabilities);
    return true;
}

} // namespace edgeshade
