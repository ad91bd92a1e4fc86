#include "preprocess/section/solid_triangles.hpp"

namespace edgeshade {

std::vector<std::uint8_t> solidTriangles(const Geometry& geometry,
                                         const std::vector<Material>& materials,
                                         std::optional<MeshTopology>& topology) {
    std::vector<std::uint8_t> solid(geometry.indices.size() / 3, 0);
    std::vector<std::uint32_t> indices; // of opaque triangles
    std::vector<std::uint32_t> numbers; // of the geometry's triangles
    for (const SurfaceGroup& group : geometry.groups) {
        if (!materials[group.material].casts(false)) continue;
        for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount; ++i)
            indices.push_back(geometry.indices[i]);
        for (std::uint32_t t = 0; t < group.indexCount / 3; ++t)
            numbers.push_back(group.firstIndex / 3 + t);
    }
    std::optional<MeshTopology> ofSome;
    std::optional<MeshTopology>& used = indices == geometry.indices ? topology : ofSome;
    if (!used) used = topologyOf(geometry.positions, indices);
    const auto& [mesh, edges, components] = *used;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        solid[numbers[mesh.source[t]]] = components.closed[components.ofTriangle[t]];
    return solid;
}

} // namespace edgeshade
