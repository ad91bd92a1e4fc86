#include "src/engine/prepared_mesh.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"
#include "preprocess/scene/triangle_mesh.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/plan/solid_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace edgeshade {
namespace {

// Bits of a material's number in maskMaterials().
constexpr std::size_t singleSided = 1, receives = 2, alphaTested = 4, hidden = 8;

std::size_t materialOf(const MaskMesh& mesh) {
    return (mesh.doubleSided ? 0 : singleSided) + (mesh.casts ? 0 : receives) +
           (mesh.alphaTested ? alphaTested : 0) + (mesh.visible ? 0 : hidden);
}

std::vector<glm::vec2> texcoordsOf(const MaskMesh& mesh, std::size_t vertices) {
    std::vector<glm::vec2> texcoords(vertices, glm::vec2(0.0f));
    const std::span<const float> given = mesh.texcoords;
    if (given.empty()) return texcoords;
    if (given.size() != 2 * vertices)
        throw InputError("A mesh of " + std::to_string(vertices) + " vertices has " +
                         std::to_string(given.size()) +
                         " texture coordinate numbers, not two per vertex.");
    for (std::size_t i = 0; i < vertices; ++i) {
        texcoords[i] = {given[2 * i], given[2 * i + 1]};
        if (!std::isfinite(texcoords[i].x) || !std::isfinite(texcoords[i].y))
            throw InputError("Vertex " + std::to_string(i) +
                             " of a mesh has a texture coordinate that is not finite.");
    }
    return texcoords;
}

/// Makes coordinates 0 that are beneath double rounding beside the largest one. Seams that a sine
/// of a whole turn leaves open, as those of three.js's spheres, close so: the corners differ by
/// 2^-52 of it.
void closeRoundedSeams(std::vector<glm::vec3>& positions) {
    double largest = 0.0;
    for (const glm::vec3& p : positions)
        largest = std::max(largest, largestComponent(p));
    const double rounding = std::ldexp(largest, -50);
    for (glm::vec3& p : positions)
        for (int i = 0; i < 3; ++i)
            if (std::abs(p[i]) < rounding) p[i] = 0.0f;
}

Geometry geometryOf(const MaskMesh& from) {
    TriangleMesh mesh = triangleMesh(from.positions, from.indices);
    closeRoundedSeams(mesh.positions);
    Geometry geometry;
    const std::size_t vertices = mesh.positions.size();
    geometry.positions = std::move(mesh.positions);
    geometry.normals.resize(vertices, glm::vec3(0.0f));
    geometry.texcoords = texcoordsOf(from, vertices);
    geometry.colors.resize(vertices, glm::vec4(1.0f));
    geometry.indices = std::move(mesh.indices);
    if (!geometry.indices.empty())
        geometry.groups = {
            {materialOf(from), 0, static_cast<std::uint32_t>(geometry.indices.size())}};
    return geometry;
}

} // namespace

std::shared_ptr<const PreparedMesh::Data> preparedFrom(Geometry geometry, bool testsAlpha,
                                                       bool solid) {
    Batch batch;
    batch.geometry = CopyOnWrite<Geometry>(std::move(geometry));
    const std::vector<Material> materials = maskMaterials();
    const Casters casters = castersOf(batch, materials, true);
    auto shadow =
        std::make_shared<PlanePairShadow>(buildPlanePairs(batch, casters, materials, 0.0));
    shadow->solids =
        solid ? findSolids(*shadow) : std::vector<std::uint8_t>(shadow->clusters.size(), 0);
    std::vector<glm::vec4> corners;
    const bool mayHaveHoles =
        std::any_of(shadow->clusters.begin(), shadow->clusters.end(),
                    [](const ShadowCluster& cluster) { return cluster.alphaTested; });
    if (mayHaveHoles)
        corners = alphaCorners(batch, casters, weldForRecords(batch, casters), *shadow);
    return std::make_shared<const PreparedMesh::Data>(
        PreparedMesh::Data{batch.geometry, std::move(shadow), testsAlpha, std::move(corners)});
}

PreparedMesh::PreparedMesh(const MaskMesh& mesh)
    : data_(preparedFrom(geometryOf(mesh), mesh.alphaTested, !mesh.bends)) {}

std::optional<std::size_t> hiddenMaterial(std::size_t material) {
    return (material & receives) == 0 ? std::optional(material | hidden) : std::nullopt;
}

bool isHidden(std::size_t material) {
    return (material & hidden) != 0;
}

std::vector<Material> maskMaterials() {
    std::vector<Material> made(maskMaterialCount);
    for (std::size_t i = 0; i < made.size(); ++i) {
        made[i].doubleSided = (i & singleSided) == 0;
        // Like a ground, it casts nothing, even where MASK surfaces cast.
        if (i & receives) made[i].ground = GroundMaterial::surface;
        if (i & alphaTested) made[i].alphaMode = AlphaMode::mask;
        if ((i & hidden) == 0) continue;
        made[i].section = SectionPart::away;
        if ((i & alphaTested) == 0) made[i].alphaMode = AlphaMode::blend;
    }
    return made;
}

} // namespace edgeshade
