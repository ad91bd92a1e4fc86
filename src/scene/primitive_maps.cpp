#include "src/scene/primitive_maps.hpp"

#include "src/scene/receivers.hpp"
#include "src/scene/scene_facts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edgeshade {
namespace {

constexpr double moreWouldNotHelp = std::numeric_limits<double>::infinity();

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

bool PrimitiveMaps::needsJob(const LoadedScene& loaded, const Light& light,
                             const ShadowPolicy& policy, std::size_t room) {
    if (const std::size_t place = placeOf(light); place < kept_.size()) {
        const Kept& kept = kept_[place];
        const auto enough = std::max(2.0 * kept.room, static_cast<double>(leastLookupBytes));
        if (kept.state.map || static_cast<double>(room) < enough) return false;
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(place));
    }
    if (std::string why = policy.lookupObstacle(lightFactsOf(light, loaded)); !why.empty()) {
        keep(light, {nullptr, std::move(why), 0.0}, moreWouldNotHelp);
        return false;
    }
    std::string why = policy.roomObstacle(room);
    if (why.empty()) return true;
    keep(light, {nullptr, std::move(why), 0.0}, static_cast<double>(room));
    return false;
}

/// Batches that the builder didn't know (the ground) get no sided triangles.
void PrimitiveMaps::take(const BuiltPrimitiveMap& built, std::size_t batches,
                         const MapDemand& demand, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    PrimitiveMapState state{nullptr, "at rest", built.milliseconds};
    double room = moreWouldNotHelp;
    std::string refusal = demand.policy.lookupRefusal(
        {refusalOf({built.map.has_value(), built.tooFar, built.tooLong, built.mostBytes}),
         built.map ? built.map->meanList : 0.0});
    if (!refusal.empty()) {
        state.why = std::move(refusal);
        if (!built.tooFar && built.tooLong == 0 && !built.map)
            room = static_cast<double>(built.mostBytes);
    } else {
        auto map = std::make_shared<GpuPrimitiveMap>(
            uploadPrimitiveMap(*built.map, built.triangles, cutouts_, capabilities));
        map->sided.resize(std::max(map->sided.size(), batches));
        state.map = std::move(map);
    }
    keep(built.light, std::move(state), room);
    keepWhatFits(demand, settings.mostBytes);
    if (!of(built.light)) // other lights became more important meanwhile
        keep(built.light, {nullptr, demand.policy.roomObstacle(0), built.milliseconds},
             static_cast<double>(built.mostBytes));
}

PrimitiveMapTask PrimitiveMaps::taskOf(const LoadedScene& loaded, const Light& light,
                                       PrimitiveMapSettings settings,
                                       const gl::Capabilities& capabilities) {
    std::optional<Section> section;
    if (loaded.scene.cutFrom) section = loaded.scene.cutFrom->section;
    settings.othersReceive = othersReceive(loaded);
    if (light.extent) {
        settings.size = sizeForExtents(settings.size);
        settings.mostSplits = 0;
        settings.receivers = receiversOf(loaded);
    }
    if (!loaded.cutoutsCast)
        return {light, castersReceive_, std::move(settings), std::move(section)};
    if (!cutouts_) {
        const CutoutAtlas atlas = cutoutAtlasOf(loaded, capabilities.largestTexture);
        textures_ = atlas.textures;
        cutouts_ = std::make_shared<const AlphaTexture>(
            uploadAlpha(atlas.alpha, atlas.width, atlas.height));
    }
    settings.cutouts = textures_;
    return {light, castersReceive_, std::move(settings), std::move(section)};
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
        if (needsJob(loaded, light, demand.policy, left / 2)) {
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
