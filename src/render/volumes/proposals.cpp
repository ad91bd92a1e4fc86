#include "src/render/volumes/proposals.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Frames after which what none of them needed is forgotten: groups of casters for a light that has
/// moved on, say. Some callers draw a frame's lights one by one.
constexpr std::size_t framesKept = 16;

} // namespace

std::size_t ProposedRecords::capBytes() const {
    std::size_t total = 0;
    for (const auto& [cluster, buffers] : caps)
        total += buffers.records.size();
    return total;
}

const CapBuffers& lightFacingCaps(const ProposedRecords& proposed, const AdaptedBuffers& buffers,
                                  std::uint32_t cluster) {
    const auto found = proposed.caps.find(cluster);
    if (found != proposed.caps.end()) return found->second;
    const AdaptedShadow& shadow = *buffers.shadow();
    const RecordRange& caps = shadow.clusters[cluster].caps;
    std::vector<CapRecord> gathered;
    for (std::uint32_t i = caps.first; i < caps.end(); ++i)
        if (mayFaceTheLight(proposed.list.facings[i])) gathered.push_back(shadow.caps[i]);
    return proposed.caps.emplace(cluster, uploadCaps(gathered, {}, buffers.layout())).first->second;
}

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

const ProposedRecords& Proposals::of(const std::shared_ptr<const AdaptedShadow>& shadow,
                                     std::size_t index, const glm::vec4& light) {
    auto source = sources_.find(shadow.get());
    if (source == sources_.end())
        source = sources_.emplace(shadow.get(), Source{shadow, LightFacings(*shadow)}).first;
    source->second.lastFrame = frame_;
    Entry& entry = entries_[{shadow.get(), index}];
    ProposedRecords& records = entry.records;
    if (entry.lastFrame == frame_) return records;
    entry.lastFrame = frame_;
    if (entry.track.follow(light)) {
        propose(*shadow, source->second.facings, entry.track.ball(), mantissaBits_, records.list);
        gather(*shadow, records);
        ++made_;
    }
    records.list.lightInPlane =
        isInSomePlane(*shadow, records.list.uncertain, light, mantissaBits_);
    return records;
}

void Proposals::gather(const AdaptedShadow& shadow, ProposedRecords& records) {
    const auto upload = [&](const PairList& list) {
        gatherPairs(shadow, list, gathered_);
        return uploadPairs(gathered_, layout_);
    };
    records.certainPairs = upload(records.list.certain);
    records.uncertainPairs = upload(records.list.uncertain);
    records.caps.clear();
}

std::size_t Proposals::sideBytes() const {
    std::size_t total = 0;
    for (const auto& [key, entry] : entries_)
        total += entry.records.sideBytes();
    return total;
}

std::size_t Proposals::capBytes() const {
    std::size_t total = 0;
    for (const auto& [key, entry] : entries_)
        total += entry.records.capBytes();
    return total;
}

} // namespace edgeshade
