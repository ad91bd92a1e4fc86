#include "src/engine/mesh_merging.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace edgeshade {
namespace {

glm::dvec3 inWorld(const PlacedMesh& of, const glm::vec3& position) {
    return of.worldFromMesh * glm::dvec4(position, 1.0);
}

Box worldBox(std::span<const PlacedMesh> members) {
    Box box;
    for (const PlacedMesh& of : members)
        for (const glm::vec3& position : of.mesh->geometry->positions)
            box.add(inWorld(of, position));
    return box;
}

/// Adds a member's triangles, with positions relative to `origin`.
void append(const PlacedMesh& of, const glm::dvec3& origin, std::vector<float>& positions,
            std::vector<std::uint32_t>& indices) {
    const auto first = static_cast<std::uint32_t>(positions.size() / 3);
    for (const glm::vec3& position : of.mesh->geometry->positions) {
        const glm::vec3 at(inWorld(of, position) - origin);
        positions.insert(positions.end(), {at.x, at.y, at.z});
    }
    const bool mirrored = glm::determinant(glm::dmat3(of.worldFromMesh)) < 0.0;
    const std::vector<std::uint32_t>& own = of.mesh->geometry->indices;
    for (std::size_t i = 0; i < own.size(); i += 3)
        for (const std::size_t corner : {i, i + (mirrored ? 2 : 1), i + (mirrored ? 1 : 2)})
            indices.push_back(first + own[corner]);
}

} // namespace

MergeCandidate candidateOf(std::size_t number, const PlacedMesh& of) {
    return {number, of.mesh->material(), of.mesh->triangles(), worldBox({&of, 1})};
}

std::vector<std::size_t> neighbours(std::span<const MergeCandidate> candidates) {
    if (candidates.empty()) return {};
    const MergeCandidate& seed = candidates.front();
    std::vector<std::pair<double, const MergeCandidate*>> nearest;
    for (const MergeCandidate& of : candidates)
        if (of.material == seed.material)
            nearest.emplace_back(glm::distance(of.box.center(), seed.box.center()), &of);
    std::stable_sort(nearest.begin(), nearest.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> numbers;
    std::size_t triangles = 0;
    Box box;
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& [distance, of] : nearest) {
        Box wider = box;
        wider.add(of->box.low);
        wider.add(of->box.high);
        const double least = std::min(smallest, of->box.diagonal());
        const bool fits = wider.diagonal() <= mostSpread * least;
        if (!numbers.empty() && (!fits || triangles + of->triangles > mostTrianglesMerged))
            continue;
        numbers.push_back(of->number);
        triangles += of->triangles;
        box = wider;
        smallest = least;
    }
    return numbers;
}

bool mayMerge(const PreparedMesh::Data& mesh) {
    return !mesh.alphaTested && mesh.triangles() > 0 && mesh.triangles() <= mostTrianglesOfMember &&
           !isHidden(mesh.material());
}

MergedMesh merge(std::span<const PlacedMesh> members) {
    const glm::dvec3 origin = worldBox(members).center();
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (const PlacedMesh& of : members)
        append(of, origin, positions, indices);
    const Material material = maskMaterials()[members.front().mesh->material()];
    return {PreparedMesh(MaskMesh{.positions = positions,
                                  .indices = indices,
                                  .casts = material.ground == GroundMaterial::none,
                                  .doubleSided = material.doubleSided}),
            glm::translate(glm::dmat4(1.0), origin)};
}

} // namespace edgeshade
