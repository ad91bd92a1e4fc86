#include "src/scene/overflow_groups.hpp"

#include "src/scene/layered_shadow.hpp"
#include "src/shadow/layers/cut_casters.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace edgeshade {
namespace {

/// A batch's range among all casters, in the order of batches.
struct CasterRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

std::vector<CasterRange> casterRangesOf(const Scene& scene, bool castMasked) {
    std::vector<CasterRange> ranges;
    std::size_t end = 0;
    for (const std::size_t count : casterCounts(scene, castMasked)) {
        ranges.push_back({end, count});
        end += count;
    }
    return ranges;
}

/// Builds and uploads the groups of one light's casters. If all places of a mesh are each wholly in
/// one group, they share records.
class GroupUpload {
  public:
    /// `groupOf`: the group of each of the scene's casters. All three references must outlive this.
    GroupUpload(const Scene& scene, const CasterSettings& settings,
                std::span<const std::uint32_t> groupOf, VolumeRecords records)
        : scene_(scene), settings_(settings), groupOf_(groupOf), records_(records),
          first_(firstOfGeometry(scene.batches)),
          ranges_(casterRangesOf(scene, settings.castMasked)), places_(first_.size(), 0),
          whole_(first_.size()) {
        for (const std::size_t first : first_)
            ++places_[first];
    }

    GroupedShadow upload(std::size_t groupCount) {
        GroupedShadow groups;
        for (std::uint32_t group = 0; group < groupCount; ++group)
            groups.push_back(uploadGroup(group));
        return groups;
    }

  private:
    using Topology = std::shared_ptr<const GroupTopology>;

    std::vector<BatchVolumes> uploadGroup(std::uint32_t group) {
        std::vector<Topology> topology;
        std::uint32_t largest = 0;
        for (std::size_t i = 0; i < first_.size(); ++i) {
            topology.push_back(topologyOf(i, group));
            largest = std::max(largest, topology.back()->edges.largestOppositeCount());
        }
        std::vector<BatchVolumes> uploads;
        std::map<Topology, BatchVolumes> again; // for topologies that several batches share
        for (std::size_t i = 0; i < first_.size(); ++i) {
            const bool repeats = topology[i].use_count() > 2;
            const auto found = repeats ? again.find(topology[i]) : again.end();
            uploads.push_back(found != again.end() ? found->second
                                                   : uploaded(i, *topology[i], largest));
            if (repeats) again.emplace(topology[i], uploads.back());
        }
        return uploads;
    }

    Topology topologyOf(std::size_t batch, std::uint32_t group) {
        const auto of = groupOf_.subspan(ranges_[batch].first, ranges_[batch].count);
        const bool together =
            std::adjacent_find(of.begin(), of.end(), std::not_equal_to()) == of.end();
        if (places_[first_[batch]] == 1 || !together) return partOf(batch, of, group);
        if (of.empty() || of.front() != group) return nothing_;
        Topology& whole = whole_[first_[batch]];
        if (!whole) whole = partOf(batch, of, group);
        return whole;
    }

    Topology partOf(std::size_t batch, std::span<const std::uint32_t> groupOf,
                    std::uint32_t group) const {
        return std::make_shared<const GroupTopology>(groupTopology(
            scene_.batches[batch], scene_.materials, settings_.castMasked, groupOf, group));
    }

    BatchVolumes uploaded(std::size_t batchIndex, const GroupTopology& topology,
                          std::uint32_t largest) const {
        const auto& [casters, mesh, edges] = topology;
        const Batch& batch = scene_.batches[batchIndex];
        const bool alphaTested = scene_.mayHaveHoles(settings_.castMasked);
        BatchVolumes volumes;
        if (records_.volumes == VolumeLayout::planePairs) {
            auto shadow = std::make_shared<const PlanePairShadow>(
                buildPlanePairs(mesh, edges, scene_.materials, settings_.flatTolerance));
            volumes.planePairs = std::make_shared<PlanePairBuffers>(
                shadow,
                alphaTested ? alphaCorners(batch, casters, mesh, *shadow)
                            : std::vector<glm::vec4>(),
                records_.layout);
        } else {
            volumes.further.push_back(
                {records_,
                 records_.source->ofGroup(batch, topology, alphaTested, largest, records_.layout)});
        }
        return volumes;
    }

    const Scene& scene_;
    const CasterSettings& settings_;
    std::span<const std::uint32_t> groupOf_;
    VolumeRecords records_;
    std::vector<std::size_t> first_; ///< firstOfGeometry()
    std::vector<CasterRange> ranges_;
    std::vector<std::size_t> places_; ///< number of a geometry's places, by its first batch
    std::vector<Topology> whole_;     ///< by a geometry's first batch
    const Topology nothing_ = std::make_shared<const GroupTopology>();
};

/// Identifies a light's groups: all points of one light have the same.
glm::dvec4 placeOf(const FrameLight& light) {
    if (light.among) return light.among->region.center;
    return light.points.empty() ? light.light.position : regionOf(light.light).center;
}

GroupedShadow uploadGroups(const LoadedScene& loaded, const FrameLight& light,
                           VolumeRecords records) {
    const LayerBound& layers = light.layers;
    if (!light.cut)
        return GroupUpload(loaded.scene, loaded.settings, layers.groupOf, records)
            .upload(layers.groupCount);
    const CutCasters cut = cutCasters(loaded.scene, loaded.settings.castMasked, *light.cut);
    std::vector<std::uint32_t> groupOf;
    for (std::size_t i = 0; i < cut.from.size(); ++i) {
        const std::uint32_t group = layers.groupCount > 1 ? layers.groupOf[cut.from[i]] : 0;
        groupOf.push_back(2 * group + (cut.inside[i] ? 1 : 0));
    }
    return GroupUpload(cut.scene, loaded.settings, groupOf, records).upload(light.groupCount());
}

/// The records of a batch of a group, which has them in one layout.
const void* recordsIn(const BatchVolumes& volumes) {
    if (volumes.planePairs) return volumes.planePairs.get();
    return volumes.further.empty() ? nullptr : volumes.further.front().buffers.get();
}

/// The sum of `bytesOf` over all batches of all groups.
template <class Kept, class BytesOf>
std::size_t sumOver(const std::vector<Kept>& kept, BytesOf bytesOf) {
    std::size_t total = 0;
    std::set<const void*> counted; // buffers that several batches share
    for (const Kept& light : kept)
        for (const auto& [layout, groups] : light.groups)
            for (const auto& group : groups)
                for (const BatchVolumes& volumes : group)
                    if (counted.insert(recordsIn(volumes)).second) total += bytesOf(volumes);
    return total;
}

/// For const and mutable containers.
template <class Kept>
auto groupsOf(Kept& kept, const FrameLight& light, VolumeLayout layout)
    -> decltype(&kept.front().groups.begin()->second) {
    for (auto& entry : kept) {
        if (!entry.isOf(placeOf(light), light)) continue;
        const auto found = entry.groups.find(layout);
        return found != entry.groups.end() ? &found->second : nullptr;
    }
    return nullptr;
}

} // namespace

void OverflowGroups::upload(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                            VolumeRecords records) {
    std::vector<Kept> kept;
    for (const FrameLight& of : lights) {
        const auto isThere = [&](const Kept& entry) { return entry.isOf(placeOf(of), of); };
        if (of.groupCount() <= 1 || std::any_of(kept.begin(), kept.end(), isThere)) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), isThere);
        if (!of.drawn && found == kept_.end()) continue;
        Kept& entry =
            kept.emplace_back(found != kept_.end() ? std::move(*found)
                                                   : Kept{placeOf(of), of.light.range, of.cut, {}});
        if (!entry.groups.contains(records.volumes))
            entry.groups.emplace(records.volumes, uploadGroups(loaded, of, records));
    }
    kept_ = std::move(kept);
}

GroupedShadow* OverflowGroups::of(const FrameLight& light, VolumeLayout layout) {
    return groupsOf(kept_, light, layout);
}

const GroupedShadow* OverflowGroups::of(const FrameLight& light, VolumeLayout layout) const {
    return groupsOf(kept_, light, layout);
}

std::size_t OverflowGroups::sideBytes() const {
    return sumOver(kept_, [](const BatchVolumes& volumes) { return volumes.sideBytes(); });
}

std::size_t OverflowGroups::capBytes() const {
    return sumOver(kept_, [](const BatchVolumes& volumes) { return volumes.capBytes(); });
}

} // namespace edgeshade
