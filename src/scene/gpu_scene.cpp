#include "src/scene/gpu_scene.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// What of a batch casts, welded; found anew only where casters may have holes.
struct HoleSource {
    Casters casters;
    CasterMesh mesh;
};

std::optional<HoleSource> holeSource(const LoadedScene& loaded, const Batch& batch) {
    if (!loaded.settings.castMasked) return std::nullopt;
    HoleSource source{castersOf(batch, loaded.scene.materials, true), {}};
    source.mesh = weldCasters(batch, source.casters);
    return source;
}

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

void addAdapted(GpuScene& gpu, const LoadedScene& loaded, SidesLayout layout) {
    for (std::size_t i = 0; i < gpu.batches.size(); ++i) {
        const Batch& batch = loaded.scene.batches[i];
        const auto& shadow = loaded.adapted[i];
        const auto source = holeSource(loaded, batch);
        gpu.batches[i].volumes.adapted.emplace(
            shadow,
            source ? capHoles(batch, source->casters, source->mesh, *shadow)
                   : std::vector<glm::vec4>(),
            layout);
    }
}

void addPublished(GpuScene& gpu, const LoadedScene& loaded, SidesLayout layout) {
    std::vector<BatchShadow> made;
    if (loaded.shadows.empty()) made = buildShadows(loaded.scene, loaded.settings.castMasked);
    const std::vector<BatchShadow>& shadows = loaded.shadows.empty() ? made : loaded.shadows;
    for (std::size_t i = 0; i < gpu.batches.size(); ++i) {
        const Batch& batch = loaded.scene.batches[i];
        const auto source = holeSource(loaded, batch);
        gpu.batches[i].volumes.published = uploadShadow(
            shadows[i],
            source ? capHoles(batch, source->casters, source->mesh) : std::vector<glm::vec4>(),
            layout);
    }
}

} // namespace

std::size_t GpuScene::shadowBytes() const {
    std::size_t total = 0;
    for (const GpuBatch& batch : batches)
        total += batch.volumes.bytes();
    return total;
}

GpuScene uploadScene(const LoadedScene& loaded, std::optional<VolumeRecords> records,
                     const gl::Capabilities& capabilities) {
    const Scene& scene = loaded.scene;
    GpuScene gpu{{}, scene.materials, Textures(loaded, capabilities), loaded.settings.castMasked};
    for (const Batch& batch : scene.batches)
        gpu.batches.push_back({batch.worldFromBatch, false, uploadSurfaces(batch), {}});
    if (records) addVolumes(gpu, loaded, *records);
    return gpu;
}

void addVolumes(GpuScene& gpu, const LoadedScene& loaded, VolumeRecords records) {
    if (gpu.batches.empty()) return;
    const BatchVolumes& there = gpu.batches.front().volumes;
    if (records.volumes == VolumeLayout::adapted && !there.adapted)
        addAdapted(gpu, loaded, records.layout);
    if (records.volumes == VolumeLayout::published && !there.published)
        addPublished(gpu, loaded, records.layout);
}

GroupedShadow uploadGroups(const LoadedScene& loaded, std::span<const std::uint32_t> groupOf,
                           std::size_t groupCount, VolumeRecords records) {
    GroupedShadow groups;
    for (std::uint32_t g = 0; g < groupCount; ++g)
        groups.push_back(uploadGroup(
            loaded, groupTopology(loaded.scene, loaded.settings.castMasked, groupOf, g), records));
    return groups;
}

} // namespace edgeshade
