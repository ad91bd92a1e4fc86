#include "src/scene/solid_surfaces.hpp"

#include "preprocess/mesh/solid_components.hpp"
#include "preprocess/mesh/topology.hpp"

#include <algorithm>
#include <span>

namespace edgeshade {
namespace {

/// `solidOf`: by triangle of the part.
void sortChunk(const SurfacePart& part, std::span<const std::uint32_t> solidOf,
               const SolidSurfaces& solids, SurfaceChunk& chunk) {
    std::vector<std::uint16_t> others, last;
    std::vector<std::uint32_t> met;
    for (std::size_t t = 0; t < solidOf.size(); ++t) {
        const bool solid = solidOf[t] != SolidSurfaces::none;
        const auto corners = part.indices.begin() + static_cast<std::ptrdiff_t>(3 * t);
        (solid ? last : others).insert((solid ? last : others).end(), corners, corners + 3);
        if (solid) met.push_back(solidOf[t]);
    }
    if (met.empty()) return;
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (const std::uint32_t solid : met)
        chunk.solids.push_back(solids.bounds[solid]);
    chunk.firstSolidIndex = static_cast<int>(others.size());
    others.insert(others.end(), last.begin(), last.end());
    chunk.indices = gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(others)));
}

void sortBatch(const Batch& batch, const std::vector<Material>& materials,
               std::vector<SurfaceChunk>& chunks) {
    const SolidSurfaces solids = solidSurfacesOf(batch, materials);
    if (solids.bounds.empty()) return;
    const std::vector<SurfacePart> parts = surfacePartsOf(batch);
    std::size_t first = 0; // of the opaque triangles, which come in the order of the parts
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!materials[parts[i].material].casts(false)) continue;
        const std::size_t count = parts[i].indices.size() / 3;
        sortChunk(parts[i], std::span(solids.ofTriangle).subspan(first, count), solids, chunks[i]);
        first += count;
    }
}

} // namespace

SolidSurfaces solidSurfacesOf(const Batch& batch, const std::vector<Material>& materials) {
    if (batch.deforms() || batch.ground) return {};
    const Casters surfaces = castingSurfacesOf(*batch.geometry, materials, false);
    const WeldedMesh mesh = weld(batch.geometry->positions, surfaces.indices);
    const EdgeList edges = buildEdges(mesh);
    const Components components = findComponents(mesh, edges);
    const std::vector<std::uint8_t> solid = solidComponents(mesh, edges, components);

    SolidSurfaces result;
    result.ofTriangle.assign(surfaces.indices.size() / 3, SolidSurfaces::none);
    std::vector<std::uint32_t> number(solid.size());
    for (std::size_t c = 0; c < solid.size(); ++c)
        if (solid[c]) {
            number[c] = static_cast<std::uint32_t>(result.bounds.size());
            result.bounds.emplace_back();
        }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t component = components.ofTriangle[t];
        if (!solid[component]) continue;
        result.ofTriangle[mesh.source[t]] = number[component];
        for (const std::uint32_t corner : mesh.triangles[t])
            result.bounds[number[component]].add(mesh.positions[corner]);
    }
    return result;
}

void sortSolidsLast(GpuScene& gpu, const LoadedScene& loaded) {
    if (gpu.solidsLast) return;
    gpu.solidsLast = true;
    for (std::size_t i = 0; i < gpu.batches.size(); ++i)
        if (gpu.batches[i].owns)
            sortBatch(loaded.scene.batches[i], gpu.materials, *gpu.batches[i].surfaces);
}

} // namespace edgeshade
