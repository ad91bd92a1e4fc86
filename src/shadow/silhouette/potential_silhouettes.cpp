#include "src/shadow/silhouette/potential_silhouettes.hpp"

namespace edgeshade {
namespace {

/// Frames after which an unused list is deleted, such as a group of casters for a light that has
/// moved on. Some callers draw up to 32 lights one by one.
constexpr std::size_t framesKept = 64;

std::array<std::uint32_t, 4> bitsOf(const glm::vec4& value) {
    return {glm::floatBitsToUint(value.x), glm::floatBitsToUint(value.y),
            glm::floatBitsToUint(value.z), glm::floatBitsToUint(value.w)};
}

std::size_t recordsOf(const PlanePairShadow& shadow) {
    return shadow.pairs.size() + shadow.singles.size() + shadow.caps.size();
}

} // namespace

void PotentialSilhouettes::beginFrame(const std::shared_ptr<const int>& scene,
                                      std::size_t mostListed) {
    ++frame_;
    mostListed_ = mostListed;
    if (scene_ != scene) {
        scene_ = scene;
        entries_.clear();
        sources_.clear();
    }
    const auto unused = [&](const auto& item) {
        return item.second.lastFrame + framesKept < frame_;
    };
    // Records held by nobody else are of an earlier pose.
    const auto isPassed = [](const Source& source) { return source.shadow.use_count() == 1; };
    std::erase_if(entries_, [&](const auto& item) {
        return unused(item) || isPassed(sources_.at(std::get<0>(item.first)));
    });
    std::erase_if(sources_,
                  [&](const auto& item) { return unused(item) || isPassed(item.second); });
}

void PotentialSilhouettes::Source::forgetRequests() {
    while (!asked.empty())
        spare.push_back(asked.extract(asked.begin()));
}

std::pair<std::size_t, std::size_t>
PotentialSilhouettes::Source::firstToAsk(const Asked::key_type& request, const SilhouetteKey& key) {
    const auto found = asked.find(request);
    if (found != asked.end()) return found->second;
    const std::pair first(key.batch, key.light);
    if (spare.empty()) return asked.emplace(request, first).first->second;
    Asked::node_type node = std::move(spare.back());
    spare.pop_back();
    node.key() = request;
    node.mapped() = first;
    return asked.insert(std::move(node)).position->second;
}

const SilhouetteList* PotentialSilhouettes::of(const SilhouetteKey& key, const glm::vec4& light) {
    if (mostListed_ == 0) return nullptr;
    const PlanePairShadow& shadow = *key.shadow;
    auto found = sources_.find(&shadow);
    if (found == sources_.end())
        found = sources_.emplace(&shadow, Source{key.shadow, LightFacings(shadow)}).first;
    Source& source = found->second;
    if (source.lastFrame != frame_) source.forgetRequests();
    source.lastFrame = frame_;
    const auto [batch, index] =
        source.firstToAsk({bitsOf(key.around ? key.around->center : light), key.range}, key);
    Entry& entry = entries_[{&shadow, batch, index}];
    SilhouetteList& list = entry.list;
    if (entry.lastFrame == frame_ && !key.around) return &list;
    entry.lastFrame = frame_;
    const bool moved = key.around ? entry.track.take(*key.around) : entry.track.follow(light);
    if (moved || entry.range != key.range || entry.reach != key.reach) {
        entry.range = key.range;
        entry.reach = key.reach;
        LightBall ball = entry.track.ball();
        ball.reach = key.reach;
        listSilhouettes(shadow, source.facings, ball, mantissaBits_, list, key.range, memory_);
        entry.uncertain.gather(shadow, list.uncertain, taken_);
        if (!list.identity) list.identity = std::make_shared<const int>(0);
        ++list.version;
        ++made_;
        mostListed_ -= std::min(mostListed_, recordsOf(shadow));
    }
    list.lightInPlane = entry.uncertain.mayHold(light, key.reach, mantissaBits_);
    return &list;
}

} // namespace edgeshade
