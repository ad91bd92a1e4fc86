#include "src/shadow/primitive_map/caster_edges.hpp"

#include <algorithm>

namespace edgeshade {

CasterEdges casterEdgesOf(const PlanePairShadow& shadow) {
    CasterEdges casters{weldCaps(shadow.caps), {}};
    casters.edges = buildEdges(casters.mesh);
    return casters;
}

namespace {

/// Whether each edge is run through as often in one direction as in the other.
bool areClosed(const EdgeList& edges) {
    return std::all_of(edges.edges.begin(), edges.edges.end(), [&](const Edge& edge) {
        const auto forward = edges.forwardOf(edge);
        const auto along = std::count(forward.begin(), forward.end(), std::uint8_t{1});
        return 2 * along == static_cast<std::ptrdiff_t>(forward.size());
    });
}

} // namespace

CasterEdges tintedEdgesOf(const Batch& batch, std::uint32_t material) {
    CasterEdges casters{weld(batch.geometry->positions, batch.geometry->indices), {}, {}};
    casters.edges = buildEdges(casters.mesh);
    for (const std::uint32_t source : casters.mesh.source) {
        CutoutTriangle& triangle = casters.cutouts.emplace_back();
        triangle.material = material;
        for (std::size_t i = 0; i < 3; ++i)
            triangle.corners[i] = {
                batch.geometry->texcoords[batch.geometry->indices[3 * source + i]], 1.0f};
    }
    casters.tintedSolid = areClosed(casters.edges);
    return casters;
}

CasterEdges cutoutEdgesOf(const Batch& batch, const std::vector<Material>& materials) {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> materialOf; // by triangle
    for (const SurfaceGroup& group : batch.geometry->groups) {
        if (materials[group.material].alphaMode != AlphaMode::mask) continue;
        const auto first = batch.geometry->indices.begin() + group.firstIndex;
        indices.insert(indices.end(), first, first + group.indexCount);
        materialOf.resize(indices.size() / 3, static_cast<std::uint32_t>(group.material));
    }
    CasterEdges casters{weld(batch.geometry->positions, indices), {}, {}};
    casters.edges = buildEdges(casters.mesh);
    for (const std::uint32_t source : casters.mesh.source) {
        CutoutTriangle& triangle = casters.cutouts.emplace_back();
        triangle.material = materialOf[source];
        const float factor = materials[triangle.material].baseColorFactor.a;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = indices[3 * source + i];
            triangle.corners[i] = {batch.geometry->texcoords[vertex],
                                   factor * batch.geometry->colors[vertex].a};
        }
    }
    return casters;
}

} // namespace edgeshade
