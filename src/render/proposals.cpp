#include "src/render/proposals.hpp"

#include "preprocess/error.hpp"

namespace edgeshade {
namespace {

/// Frames after which what none of them needed is forgotten: groups of casters for a light that has
/// moved on, say. Some callers draw a frame's lights one by one.
constexpr std::size_t framesKept = 16;

} // namespace

void Proposals::beginFrame(const std::shared_ptr<const int>& scene) {
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

const ProposedPairs& Proposals::of(const std::shared_ptr<const AdaptedShadow>& shadow,
                                   std::size_t index, const glm::vec4& light) {
    auto source = sources_.find(shadow.get());
    if (source == sources_.end())
        source = sources_.emplace(shadow.get(), Source{shadow, LightFacings(*shadow)}).first;
    source->second.lastFrame = frame_;
    Entry& entry = entries_[{shadow.get(), index}];
    if (entry.lastFrame == frame_) return entry.pairs;
    entry.lastFrame = frame_;
    if (!entry.track.follow(light)) return entry.pairs;
    propose(*shadow, source->second.facings, entry.track.ball(), mantissaBits_, entry.pairs.list);
    gather(*shadow, entry.pairs);
    ++made_;
    return entry.pairs;
}

void Proposals::gather(const AdaptedShadow& shadow, ProposedPairs& pairs) {
    gathered_.clear();
    gathered_.reserve(pairs.list.pairs.size());
    for (const std::uint32_t pair : pairs.list.pairs)
        gathered_.push_back(shadow.pairs[pair]);
    pairs.records = uploadPairs(gathered_, layout_);
}

std::size_t Proposals::bytes() const {
    std::size_t total = 0;
    for (const auto& [key, entry] : entries_)
        total += entry.pairs.records.size();
    return total;
}

} // namespace edgeshade
