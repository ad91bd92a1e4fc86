#include "src/engine/prepared_mesh.hpp"

#include "preprocess/scene/triangle_mesh.hpp"
#include "src/shadow/plan/solid_clusters.hpp"

namespace edgeshade {
namespace {

/// Of maskMaterials().
std::size_t materialOf(const MaskMesh& mesh) {
    return (mesh.casts ? 0u : 2u) + (mesh.doubleSided ? 0u : 1u);
}

Geometry geometryOf(const MaskMesh& from) {
    TriangleMesh mesh = triangleMesh(from.positions, from.indices);
    Geometry geometry;
    const std::size_t vertices = mesh.positions.size();
    geometry.positions = std::move(mesh.positions);
    geometry.normals.resize(vertices, glm::vec3(0.0f));
    geometry.texcoords.resize(vertices);
    geometry.colors.resize(vertices, glm::vec4(1.0f));
    geometry.indices = std::move(mesh.indices);
    if (!geometry.indices.empty())
        geometry.groups = {
            {materialOf(from), 0, static_cast<std::uint32_t>(geometry.indices.size())}};
    return geometry;
}

std::shared_ptr<const PreparedMesh::Data> prepared(const MaskMesh& mesh) {
    Batch batch;
    batch.geometry = CopyOnWrite<Geometry>(geometryOf(mesh));
    const std::vector<Material> materials = maskMaterials();
    auto shadow = std::make_shared<PlanePairShadow>(
        buildPlanePairs(batch, castersOf(batch, materials, false), materials, 0.0));
    shadow->solids =
        mesh.bends ? std::vector<std::uint8_t>(shadow->clusters.size(), 0) : findSolids(*shadow);
    return std::make_shared<const PreparedMesh::Data>(
        PreparedMesh::Data{batch.geometry, std::move(shadow)});
}

} // namespace

PreparedMesh::PreparedMesh(const MaskMesh& mesh) : data_(prepared(mesh)) {}

std::vector<Material> maskMaterials() {
    std::vector<Material> made(4);
    made[0].doubleSided = made[2].doubleSided = true;
    for (const std::size_t receiving : {2u, 3u}) {
        // All of it is seen, and MASK surfaces cast nothing.
        made[receiving].alphaMode = AlphaMode::mask;
        made[receiving].alphaCutoff = 0.0f;
    }
    return made;
}

} // namespace edgeshade
