#include "src/scene/overflow_groups.hpp"

#include "src/scene/layered_shadow.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Shadow data of every batch in its group, by the layout.
std::vector<BatchVolumes> uploadGroup(const LoadedScene& loaded,
                                      const std::vector<GroupTopology>& topology,
                                      VolumeRecords records) {
    const Scene& scene = loaded.scene;
    std::uint32_t largest = 0;
    for (const GroupTopology& of : topology)
        largest = std::max(largest, of.edges.largestOppositeCount());
    std::vector<BatchVolumes> group;
    for (std::size_t i = 0; i < topology.size(); ++i) {
        const auto& [casters, mesh, edges] = topology[i];
        const Batch& batch = scene.batches[i];
        const bool holes = loaded.settings.castMasked;
        BatchVolumes& volumes = group.emplace_back();
        if (records.volumes == VolumeLayout::adapted) {
            auto shadow = std::make_shared<const AdaptedShadow>(
                buildAdapted(mesh, edges, scene.materials, loaded.settings.flatTolerance));
            volumes.adapted.emplace(
                shadow, holes ? capHoles(batch, casters, mesh, *shadow) : std::vector<glm::vec4>(),
                records.layout);
        } else {
            const BatchShadow shadow{
                buildSides(mesh.welded.positions, edges, recordMultiplicityFor(largest)),
                buildCaps(mesh.welded), mesh.groups};
            volumes.published = uploadShadow(
                shadow, holes ? capHoles(batch, casters, mesh) : std::vector<glm::vec4>(),
                records.layout);
        }
    }
    return group;
}

GroupedShadow uploadGroups(const LoadedScene& loaded, const LayerBound& layers,
                           VolumeRecords records) {
    GroupedShadow groups;
    for (std::uint32_t g = 0; g < layers.groupCount; ++g)
        groups.push_back(uploadGroup(
            loaded, groupTopology(loaded.scene, loaded.settings.castMasked, layers.groupOf, g),
            records));
    return groups;
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
auto groupsOf(Kept& kept, const Light& light, VolumeLayout layout)
    -> decltype(&kept.front().groups.begin()->second) {
    for (auto& entry : kept) {
        if (entry.light != light.position) continue;
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
        const auto isThere = [&](const Kept& entry) { return entry.light == of.light.position; };
        if (of.layers.groupCount <= 1 || std::any_of(kept.begin(), kept.end(), isThere)) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), isThere);
        Kept& entry = kept.emplace_back(found != kept_.end() ? std::move(*found)
                                                             : Kept{of.light.position, {}});
        if (!entry.groups.contains(records.volumes))
            entry.groups.emplace(records.volumes, uploadGroups(loaded, of.layers, records));
    }
    kept_ = std::move(kept);
}

GroupedShadow* OverflowGroups::of(const Light& light, VolumeLayout layout) {
    return groupsOf(kept_, light, layout);
}

const GroupedShadow* OverflowGroups::of(const Light& light, VolumeLayout layout) const {
    return groupsOf(kept_, light, layout);
}

std::size_t OverflowGroups::sideBytes() const {
    return sumOver(kept_, [](const BatchVolumes& volumes) { return volumes.sideBytes(); });
}

std::size_t OverflowGroups::capBytes() const {
    return sumOver(kept_, [](const BatchVolumes& volumes) { return volumes.capBytes(); });
}

} // namespace edgeshade
