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
    std::erase_if(entries_, unused);
    std::erase_if(sources_, unused);
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
