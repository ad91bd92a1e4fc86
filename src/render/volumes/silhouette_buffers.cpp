#include "src/render/volumes/silhouette_buffers.hpp"

namespace edgeshade {

void SilhouetteBuffers::upload(const PlanePairShadow& shadow, const SilhouetteList& list) {
    Gathered& gathered = gathered_[list.identity];
    if (gathered.version == list.version) return;
    const auto uploaded = [&](const PairList& some) {
        gatherPairs(shadow, some, pairs_);
        return uploadPairs(pairs_, layout_);
    };
    gathered.caps.clear();
    gathered.certainPairs = uploaded(list.certain);
    gathered.uncertainPairs = uploaded(list.uncertain);
    gathered.version = list.version;
}

void SilhouetteBuffers::uploadCapsOf(const PlanePairShadow& shadow, const SilhouetteList& list,
                                     std::uint32_t cluster) {
    auto& uploaded = gathered_.find(list.identity)->second.caps;
    if (uploaded.contains(cluster)) return;
    const RecordRange& caps = shadow.clusters[cluster].caps;
    caps_.clear();
    caps_.reserve(list.lightFacingCaps[cluster]);
    for (std::uint32_t i = caps.first; i < caps.end(); ++i)
        if (mayFaceTheLight(list.facings[i])) caps_.push_back(shadow.caps[i]);
    uploaded.emplace(cluster, uploadCaps(caps_, {}, layout_));
}

void SilhouetteBuffers::dropExpired() {
    std::erase_if(gathered_, [](const auto& entry) { return entry.first.expired(); });
}

std::size_t SilhouetteBuffers::sideBytes() const {
    std::size_t total = 0;
    for (const auto& [list, gathered] : gathered_)
        total += gathered.certainPairs.size() + gathered.uncertainPairs.size();
    return total;
}

std::size_t SilhouetteBuffers::capBytes() const {
    std::size_t total = 0;
    for (const auto& [list, gathered] : gathered_)
        for (const auto& [cluster, caps] : gathered.caps)
            total += caps.records.size();
    return total;
}

} // namespace edgeshade
