#include "src/shadow/silhouette/potential_silhouettes.hpp"

namespace edgeshade {
namespace {

/// Frames after which what none of them needed is forgotten: groups of casters for a light that has
/// moved on, say. Some callers draw a frame's lights one by one.
constexpr std::size_t framesKept = 16;

} // namespace

void PotentialSilhouettes::beginFrame(const std::shared_ptr<const int>& scene) {
    ++frame_;
    if (scene_ != scene) {
        scene_ = scene;
        entries_.clear();
        sources_.clear();
    }
    const auto unused = [&](const auto& item) {
        return item.second.lastFrame + framesKept < frame_;
    };
    // Records that nobody else holds are of a pose that has passed.
    const auto isPassed = [](const Source& source) { return source.shadow.use_count() == 1; };
    std::erase_if(entries_, [&](const auto& item) {
        return unused(item) || isPassed(sources_.at(item.first.first));
    });
    std::erase_if(sources_,
                  [&](const auto& item) { return unused(item) || isPassed(item.second); });
}

const SilhouetteList& PotentialSilhouettes::of(const std::shared_ptr<const PlanePairShadow>& shadow,
                                               std::size_t index, const glm::vec4& light) {
    auto source = sources_.find(shadow.get());
    if (source == sources_.end())
        source = sources_.emplace(shadow.get(), Source{shadow, LightFacings(*shadow)}).first;
    source->second.lastFrame = frame_;
    Entry& entry = entries_[{shadow.get(), index}];
    SilhouetteList& list = entry.list;
    if (entry.lastFrame == frame_) return list;
    entry.lastFrame = frame_;
    if (entry.track.follow(light)) {
        listSilhouettes(*shadow, source->second.facings, entry.track.ball(), mantissaBits_, list);
        list.identity = std::make_shared<const int>(0);
        ++made_;
    }
    list.lightInPlane = isInSomePlane(*shadow, list.uncertain, light, mantissaBits_);
    return list;
}

} // namespace edgeshade
