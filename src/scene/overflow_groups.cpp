#include "src/scene/overflow_groups.hpp"

#include "src/scene/layered_shadow.hpp"
#include "src/shadow/geometry/cut_casters.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Shadow data of every batch in its group, by the layout.
std::vector<BatchVolumes> uploadGroup(const Scene& scene, const CasterSettings& settings,
                                      const std::vector<GroupTopology>& topology,
                                      VolumeRecords records) {
    std::uint32_t largest = 0;
    for (const GroupTopology& of : topology)
        largest = std::max(largest, of.edges.largestOppositeCount());
    std::vector<BatchVolumes> group;
    for (std::size_t i = 0; i < topology.size(); ++i) {
        const auto& [casters, mesh, edges] = topology[i];
        const Batch& batch = scene.batches[i];
        const bool alphaTested = settings.castMasked;
        BatchVolumes& volumes = group.emplace_back();
        if (records.volumes == VolumeLayout::planePairs) {
            auto shadow = std::make_shared<const PlanePairShadow>(
                buildPlanePairs(mesh, edges, scene.materials, settings.flatTolerance));
            volumes.planePairs.emplace(shadow,
                                       alphaTested ? alphaCorners(batch, casters, mesh, *shadow)
                                                   : std::vector<glm::vec4>(),
                                       records.layout);
        } else {
            const BatchShadow shadow{
                buildSides(mesh.welded.positions, edges, recordMultiplicityFor(largest)),
                buildCaps(mesh.welded), mesh.groups};
            volumes.oppositeVertices = uploadShadow(
                shadow, alphaTested ? alphaCorners(batch, casters, mesh) : std::vector<glm::vec4>(),
                records.layout);
        }
    }
    return group;
}

/// `groupOf`: of each caster of `scene`.
GroupedShadow uploadGroups(const Scene& scene, const CasterSettings& settings,
                           std::span<const std::uint32_t> groupOf, std::size_t groupCount,
                           VolumeRecords records) {
    GroupedShadow groups;
    for (std::uint32_t g = 0; g < groupCount; ++g)
        groups.push_back(uploadGroup(
            scene, settings, groupTopology(scene, settings.castMasked, groupOf, g), records));
    return groups;
}

GroupedShadow uploadGroups(const LoadedScene& loaded, const FrameLight& light,
                           VolumeRecords records) {
    const LayerBound& layers = light.layers;
    if (!light.cut)
        return uploadGroups(loaded.scene, loaded.settings, layers.groupOf, layers.groupCount,
                            records);
    const CutCasters cut = cutCasters(loaded.scene, loaded.settings.castMasked, *light.cut);
    std::vector<std::uint32_t> groupOf;
    for (std::size_t i = 0; i < cut.from.size(); ++i) {
        const std::uint32_t group = layers.groupCount > 1 ? layers.groupOf[cut.from[i]] : 0;
        groupOf.push_back(2 * group + (cut.inside[i] ? 1 : 0));
    }
    return uploadGroups(cut.scene, loaded.settings, groupOf, light.groupCount(), records);
}

/// The sum of `bytesOf` over all batches of all groups.
template <class Kept, class BytesOf>
std::size_t sumOver(const std::vector<Kept>& kept, BytesOf bytesOf) {
    std::size_t total = 0;
    for (const Kept& light : kept)
        for (const auto& [layout, groups] : light.groups)
            for (const auto& group : groups)
                for (const BatchVolumes& volumes : group)
                    total += bytesOf(volumes);
    return total;
}

/// Works on what is const and what isn't.
template <class Kept>
auto groupsOf(Kept& kept, const FrameLight& light, VolumeLayout layout)
    -> decltype(&kept.front().groups.begin()->second) {
    for (auto& entry : kept) {
        if (entry.light != light.light.position || entry.cut != light.cut) continue;
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
        const auto isThere = [&](const Kept& entry) {
            return entry.light == of.light.position && entry.cut == of.cut;
        };
        if (of.groupCount() <= 1 || std::any_of(kept.begin(), kept.end(), isThere)) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), isThere);
        Kept& entry = kept.emplace_back(found != kept_.end() ? std::move(*found)
                                                             : Kept{of.light.position, of.cut, {}});
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
