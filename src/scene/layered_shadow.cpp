#include "src/scene/layered_shadow.hpp"

namespace edgeshade {
namespace {

/// The casters whose triangles are in the group; `first` counts triangles over all batches.
Casters castersInGroup(const Casters& casters, std::span<const std::uint32_t> groupOf,
                       std::size_t first, std::uint32_t group) {
    Casters kept;
    for (const SurfaceGroup& range : casters.groups) {
        SurfaceGroup part{range.material, static_cast<std::uint32_t>(kept.indices.size()), 0};
        for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; i += 3)
            if (groupOf[first + i / 3] == group)
                kept.indices.insert(kept.indices.end(), casters.indices.begin() + i,
                                    casters.indices.begin() + i + 3);
        part.indexCount = static_cast<std::uint32_t>(kept.indices.size()) - part.firstIndex;
        kept.groups.push_back(part);
    }
    return kept;
}

} // namespace

std::vector<GroupTopology> groupTopology(const Scene& scene, bool castMasked,
                                         std::span<const std::uint32_t> groupOf,
                                         std::uint32_t group) {
    std::vector<GroupTopology> topology;
    std::size_t first = 0;
    for (const Batch& batch : scene.batches) {
        const Casters all = castersOf(batch, scene.materials, castMasked);
        GroupTopology& built = topology.emplace_back();
        built.casters = castersInGroup(all, groupOf, first, group);
        first += all.indices.size() / 3;
        built.mesh = weldCasters(batch, built.casters);
        built.edges = buildEdges(built.mesh.welded);
    }
    return topology;
}

} // namespace edgeshade
