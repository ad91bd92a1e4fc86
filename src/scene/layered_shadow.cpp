#include "src/scene/layered_shadow.hpp"

namespace edgeshade {
namespace {

/// The casters of one group.
Casters castersInGroup(const Casters& casters, std::span<const std::uint32_t> groupOf,
                       std::uint32_t group) {
    Casters kept;
    for (const SurfaceGroup& range : casters.groups) {
        SurfaceGroup part{range.material, static_cast<std::uint32_t>(kept.indices.size()), 0};
        for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; i += 3)
            if (groupOf[i / 3] == group)
                kept.indices.insert(kept.indices.end(), casters.indices.begin() + i,
                                    casters.indices.begin() + i + 3);
        part.indexCount = static_cast<std::uint32_t>(kept.indices.size()) - part.firstIndex;
        kept.groups.push_back(part);
    }
    return kept;
}

} // namespace

GroupTopology groupTopology(const Batch& batch, const std::vector<Material>& materials,
                            bool castMasked, std::span<const std::uint32_t> groupOf,
                            std::uint32_t group) {
    GroupTopology built;
    built.casters = castersInGroup(castersOf(batch, materials, castMasked), groupOf, group);
    built.mesh = weldCasters(batch, built.casters);
    built.edges = buildEdges(built.mesh.welded);
    return built;
}

} // namespace edgeshade
