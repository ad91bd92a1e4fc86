#include "src/scene/culled_casters.hpp"

#include "src/shadow/geometry/light_region.hpp"
#include "src/shadow/geometry/light_shape.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// How far a light that wanders gets from the middle of what is kept for it, of the way to its rim,
/// before the next is begun.
constexpr double farOut = 0.5;

/// Whether what lights shine on stays as far away as it is.
bool staysInPlace(const LoadedScene& loaded) {
    const std::vector<Batch>& batches = loaded.scene.batches;
    return std::none_of(batches.begin(), batches.end(),
                        [](const Batch& batch) { return batch.isAnimated(); });
}

/// Where casters are to be culled for a light; nothing: it moves.
std::optional<Light> wantedFor(const FrameLight& of, bool mayWander) {
    if (!CulledCasters::suits(of)) return std::nullopt;
    if (of.atRest) return of.light;
    if (of.wander > 0.0 && mayWander && !of.light.hasRange())
        return anywhereWithin(of.light, of.wander);
    return std::nullopt;
}

/// The first that is wanted and not there, if a light that wanders may be so far out in what is
/// kept.
std::optional<Light> nextOf(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                            const std::vector<CulledCasters::Kept>& kept, double share) {
    const bool mayWander = staysInPlace(loaded);
    for (const FrameLight& of : lights) {
        const std::optional<Light> wanted = wantedFor(of, mayWander);
        if (!wanted) continue;
        const auto isFor = [&](const CulledCasters::Kept& entry) {
            return wanted->extent ? isWithin(of.light, entry.light, share)
                                  : castAlike(entry.light, of.light);
        };
        if (std::none_of(kept.begin(), kept.end(), isFor)) return wanted;
    }
    return std::nullopt;
}

} // namespace

bool CulledCasters::suits(const FrameLight& light) {
    return light.drawn && light.shadowed && !light.light.extent && light.points.empty() &&
           !light.among && light.groupCount() == 1;
}

void CulledCasters::make(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                         const Form& form) {
    job_.reset();
    while (const std::optional<Light> wanted = nextOf(loaded, lights, kept_, 1.0)) {
        CullingJob job(loaded, *wanted, form.mantissaBits, edges_);
        job.finish();
        take(job, form);
    }
    keepOnly(lights);
}

bool CulledCasters::advance(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                            const Form& form) {
    const bool done = job_ && job_->isDone();
    if (done) take(*std::exchange(job_, nullptr), form);
    keepOnly(lights);
    const auto isInJob = [&](const FrameLight& of) {
        return suits(of) && isWithin(of.light, job_->light(), 1.0);
    };
    if (job_ && std::none_of(lights.begin(), lights.end(), isInJob)) job_.reset();
    if (job_) return done;
    if (const std::optional<Light> wanted = nextOf(loaded, lights, kept_, farOut)) {
        job_ = std::make_unique<CullingJob>(loaded, *wanted, form.mantissaBits, edges_);
        job_->start();
    }
    return done;
}

/// Those that some light takes.
void CulledCasters::keepOnly(const std::vector<FrameLight>& lights) {
    std::vector<const Kept*> taken;
    for (const FrameLight& of : lights)
        taken.push_back(this->of(of));
    std::vector<Kept> kept;
    for (Kept& entry : kept_)
        if (std::find(taken.begin(), taken.end(), &entry) != taken.end())
            kept.push_back(std::move(entry));
    kept_ = std::move(kept);
}

void CulledCasters::take(const CullingJob& job, const Form& form) {
    edges_ = job.edges();
    const KeptCasters& found = job.kept();
    Kept& kept = kept_.emplace_back();
    kept.light = found.light;
    kept.casters = found.casters;
    kept.gone = found.gone;
    kept.buildMs = found.milliseconds;
    kept.volumes.resize(found.shadows.size());
    for (std::size_t i = 0; i < found.shadows.size(); ++i)
        if (found.shadows[i])
            kept.volumes[i].planePairs = std::make_shared<PlanePairBuffers>(
                found.shadows[i], std::vector<glm::vec4>(), form.layout);
}

/// Where it is, if that is there, has most left out; of others the last is nearest to where it
/// goes.
const CulledCasters::Kept* CulledCasters::of(const FrameLight& light) const {
    if (!suits(light)) return nullptr;
    const Kept* best = nullptr;
    for (const Kept& kept : kept_) {
        if (castAlike(kept.light, light.light)) return &kept;
        if (isWithin(light.light, kept.light, 1.0)) best = &kept;
    }
    return best;
}

BatchVolumes* CulledCasters::of(const FrameLight& light, std::size_t batch) {
    return const_cast<BatchVolumes*>(std::as_const(*this).of(light, batch));
}

const BatchVolumes* CulledCasters::of(const FrameLight& light, std::size_t batch) const {
    const Kept* kept = of(light);
    return kept && kept->volumes[batch].planePairs ? &kept->volumes[batch] : nullptr;
}

void CulledCasters::clear() {
    job_.reset();
    kept_.clear();
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
