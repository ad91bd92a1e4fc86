#include "src/hours/surfaces/world_triangles.hpp"

#include <utility>

namespace edgeshade::hours {
namespace {

void addBatch(const Scene& scene, std::uint32_t number, const SurfaceChoice& choice,
              std::vector<WorldTriangle>& to) {
    const Batch& batch = scene.batches[number];
    const Geometry& geometry = *batch.geometry;
    const bool mirrored = batch.isMirrored();
    const auto corner = [&](std::uint32_t index) {
        const glm::vec3& at = geometry.positions[geometry.indices[index]];
        return glm::dvec3(batch.worldFromBatch * glm::dvec4(at, 1.0));
    };
    WorldTriangle triangle;
    triangle.batch = number;
    for (const SurfaceGroup& group : geometry.groups) {
        triangle.material = static_cast<std::uint32_t>(group.material);
        for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount; i += 3) {
            triangle.node = static_cast<std::uint32_t>(nodeOf(geometry, batch.placedBy, i));
            if (!choice(triangle.node, triangle.material)) continue;
            triangle.firstIndex = i;
            triangle.a = corner(i);
            triangle.b = corner(i + 1);
            triangle.c = corner(i + 2);
            if (mirrored) std::swap(triangle.b, triangle.c);
            to.push_back(triangle);
        }
    }
}

} // namespace

std::vector<WorldTriangle> worldTriangles(const Scene& scene, const SurfaceChoice& choice) {
    std::vector<WorldTriangle> triangles;
    for (std::uint32_t b = 0; b < scene.batches.size(); ++b)
        if (!scene.batches[b].ground && !scene.batches[b].hidden)
            addBatch(scene, b, choice, triangles);
    return triangles;
}

} // namespace edgeshade::hours
