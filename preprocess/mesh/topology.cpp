#include "preprocess/mesh/topology.hpp"

#include "preprocess/scene/posing.hpp"

#include <span>

namespace edgeshade {

namespace {

void add(Casters& casters, std::size_t material, std::span<const std::uint32_t> corners) {
    casters.groups.push_back({material, static_cast<std::uint32_t>(casters.indices.size()),
                              static_cast<std::uint32_t>(corners.size())});
    casters.indices.insert(casters.indices.end(), corners.begin(), corners.end());
}

} // namespace

Casters castingSurfacesOf(const Geometry& geometry, const std::vector<Material>& materials,
                          bool castMasked) {
    Casters casters;
    for (const SurfaceGroup& group : geometry.groups)
        if (materials[group.material].casts(castMasked))
            add(casters, group.material,
                std::span(geometry.indices).subspan(group.firstIndex, group.indexCount));
    return casters;
}

Casters castersOf(const Geometry& geometry, const std::vector<Material>& materials,
                  bool castMasked) {
    if (!geometry.simplifiedCasters) return castingSurfacesOf(geometry, materials, castMasked);
    Casters casters;
    for (const SurfaceGroup& group : geometry.groups) {
        const bool opaque = materials[group.material].alphaMode == AlphaMode::opaque;
        // One group holds all opaque triangles, as their materials make no difference.
        if (opaque && casters.groups.empty())
            add(casters, group.material, *geometry.simplifiedCasters);
        else if (!opaque && castMasked)
            add(casters, group.material,
                std::span(geometry.indices).subspan(group.firstIndex, group.indexCount));
    }
    return casters;
}

std::vector<std::size_t> casterCounts(const Scene& scene, bool castMasked) {
    return byGeometry(scene.batches, [&](std::size_t i) {
        return castersOf(scene.batches[i], scene.materials, castMasked).indices.size() / 3;
    });
}

CasterMesh inGroups(WeldedMesh welded, const Casters& casters) {
    CasterMesh mesh;
    mesh.welded = std::move(welded);
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

CasterMesh weldCasters(const Batch& batch, const Casters& casters, Threads threads) {
    return inGroups(weld(batch.geometry->positions, casters.indices, threads), casters);
}

CasterMesh weldForRecords(const Batch& batch, const Casters& casters) {
    if (!batch.deforms()) return weldCasters(batch, casters);
    return inGroups(weldAlike(batch.geometry->positions, alikeVertices(batch), casters.indices),
                    casters);
}

std::uint64_t positionsHash(const Batch& batch, const Casters& surfaces) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const std::uint32_t index : surfaces.indices)
        for (glm::length_t c = 0; c < 3; ++c) {
            const std::uint32_t bits = glm::floatBitsToUint(batch.geometry->positions[index][c]);
            for (int shift = 0; shift < 32; shift += 8)
                hash = (hash ^ (bits >> shift & 0xFFu)) * 0x100000001B3u;
        }
    return hash;
}

} // namespace edgeshade
