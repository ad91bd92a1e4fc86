#include "preprocess/topology.hpp"

namespace edgeshade {

Casters castersOf(const Batch& batch, const std::vector<Material>& materials, bool castMasked) {
    Casters casters;
    for (const SurfaceGroup& group : batch.groups) {
        if (materials[group.material].alphaMode != AlphaMode::opaque && !castMasked) continue;
        const auto first = batch.indices.begin() + group.firstIndex;
        casters.groups.push_back(
            {group.material, static_cast<std::uint32_t>(casters.indices.size()), group.indexCount});
        casters.indices.insert(casters.indices.end(), first, first + group.indexCount);
    }
    return casters;
}

CasterMesh weldCasters(const Batch& batch, const Casters& casters) {
    CasterMesh mesh;
    mesh.welded = weld(batch.positions, casters.indices);
    std::uint32_t cap = 0;
    const auto& source = mesh.welded.source;
    for (const SurfaceGroup& group : casters.groups) {
        const std::uint32_t end = (group.firstIndex + group.indexCount) / 3;
        const std::uint32_t first = cap;
        while (cap < source.size() && source[cap] < end)
            ++cap;
        if (cap > first) mesh.groups.push_back({group.material, first, cap - first});
    }
    return mesh;
}

std::uint64_t positionsHash(const Batch& batch, const Casters& casters) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const std::uint32_t index : casters.indices)
        for (glm::length_t c = 0; c < 3; ++c) {
            const std::uint32_t bits = glm::floatBitsToUint(batch.positions[index][c]);
            for (int shift = 0; shift < 32; shift += 8)
                hash = (hash ^ (bits >> shift & 0xFFu)) * 0x100000001B3u;
        }
    return hash;
}

} // namespace edgeshade
