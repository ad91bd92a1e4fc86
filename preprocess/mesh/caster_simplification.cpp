#include "preprocess/mesh/caster_simplification.hpp"

#include "preprocess/base/longest_axis.hpp"
#include "preprocess/mesh/topology.hpp"

#include <algorithm>
#include <meshoptimizer.h>

namespace edgeshade {
namespace {

/// One vertex of the batch for each welded position.
std::vector<std::uint32_t> verticesOf(const WeldedMesh& mesh, const Casters& casters) {
    std::vector<std::uint32_t> vertices(mesh.positions.size());
    for (std::size_t t = mesh.triangles.size(); t-- > 0;)
        for (std::size_t c = 0; c < 3; ++c)
            vertices[mesh.triangles[t][c]] = casters.indices[3 * mesh.source[t] + c];
    return vertices;
}

std::vector<std::uint32_t> simplified(const Batch& batch, const Casters& casters, double error) {
    const WeldedMesh mesh = weld(batch.geometry->positions, casters.indices);
    if (mesh.triangles.empty()) return {};
    const std::uint32_t* corners = mesh.triangles.front().data();
    const std::size_t cornerCount = 3 * mesh.triangles.size();
    const float* positions = &mesh.positions.front().x;
    const float scale = meshopt_simplifyScale(positions, mesh.positions.size(), sizeof(glm::vec3));
    std::vector<std::uint32_t> kept(cornerCount);
    kept.resize(meshopt_simplify(
        kept.data(), corners, cornerCount, positions, mesh.positions.size(), sizeof(glm::vec3), 0,
        static_cast<float>(error / static_cast<double>(scale)), 0, nullptr));
    const std::vector<std::uint32_t> vertices = verticesOf(mesh, casters);
    for (std::uint32_t& corner : kept)
        corner = vertices[corner];
    return kept;
}

} // namespace

void simplifyCasters(Scene& scene, double error) {
    if (error <= 0.0) return;
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    std::vector<double> longest(first.size(), 0.0); // over all places of a geometry
    for (std::size_t i = 0; i < first.size(); ++i)
        longest[first[i]] =
            std::max(longest[first[i]], longestAxis(scene.batches[i].worldFromBatch));
    for (std::size_t i = 0; i < first.size(); ++i) {
        Batch& batch = scene.batches[i];
        if (first[i] != i) {
            batch.geometry = scene.batches[first[i]].geometry;
            continue;
        }
        if (!batch.deforms()) // else vertices close in one pose are apart in another
            batch.geometry.edit().simplifiedCasters =
                simplified(batch, castingSurfacesOf(*batch.geometry, scene.materials, false),
                           error / longest[i]);
    }
}

} // namespace edgeshade
