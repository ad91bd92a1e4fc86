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

CasterGroupShadow groupShadow(const Scene& scene, bool castMasked,
                              std::span<const std::uint32_t> groupOf, std::uint32_t group) {
    std::vector<BatchTopology> topology;
    std::vector<Casters> castersOfBatch;
    std::size_t first = 0;
    for (const Batch& batch : scene.batches) {
        const Casters all = castersOf(batch, scene.materials, castMasked);
        castersOfBatch.push_back(castersInGroup(all, groupOf, first, group));
        first += all.indices.size() / 3;
        BatchTopology& built = topology.emplace_back();
        built.mesh = weldCasters(batch, castersOfBatch.back());
        built.edges = buildEdges(built.mesh.welded);
    }
    CasterGroupShadow result;
    const int maxMultiplicity = sceneMultiplicity(topology);
    for (std::size_t i = 0; i < topology.size(); ++i) {
        result.shadows.push_back(buildShadow(topology[i], maxMultiplicity));
        result.holes.push_back(castMasked
                                   ? capHoles(scene.batches[i], castersOfBatch[i], topology[i].mesh)
                                   : std::vector<glm::vec4>());
    }
    return result;
}

} // namespace edgeshade
