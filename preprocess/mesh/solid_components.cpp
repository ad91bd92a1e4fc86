#include "preprocess/mesh/solid_components.hpp"

#include "preprocess/mesh/triangle_crossing.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Clears components that have an edge without exactly two triangles in opposite directions.
void keepManifolds(const EdgeList& edges, const Components& components,
                   std::vector<std::uint8_t>& solid) {
    for (const Edge& edge : edges.edges) {
        const auto forward = edges.forwardOf(edge);
        if (forward.size() == 2 && forward[0] != forward[1]) continue;
        solid[components.ofTriangle[edges.opposites[edge.firstOpposite].triangle]] = 0;
    }
}

/// Clears components whose volume isn't above 0. Each sum is taken from a corner of its component.
void keepOutwards(const WeldedMesh& mesh, const Components& components,
                  std::vector<std::uint8_t>& solid) {
    std::vector<glm::dvec3> from(components.count());
    std::vector<double> volume(components.count());
    std::vector<std::uint8_t> begun(components.count());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t component = components.ofTriangle[t];
        if (!solid[component]) continue;
        const TriangleCorners corners = cornersOf(mesh, t);
        if (!begun[component]) from[component] = corners[0];
        begun[component] = 1;
        const glm::dvec3& origin = from[component];
        volume[component] +=
            glm::dot(corners[0] - origin, glm::cross(corners[1] - origin, corners[2] - origin));
    }
    for (std::size_t c = 0; c < solid.size(); ++c)
        if (!(volume[c] > 0.0)) solid[c] = 0;
}

} // namespace

std::vector<std::uint8_t> solidComponents(const WeldedMesh& mesh, const EdgeList& edges,
                                          const Components& components) {
    std::vector<std::uint8_t> solid = components.closed;
    keepManifolds(edges, components, solid);
    keepOutwards(mesh, components, solid);

    std::vector<std::uint32_t> triangles; // of solids, grouped by component
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (solid[components.ofTriangle[t]]) triangles.push_back(t);
    const auto componentOf = [&](std::uint32_t t) { return components.ofTriangle[t]; };
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](std::uint32_t one, std::uint32_t other) {
                         return componentOf(one) < componentOf(other);
                     });
    for (auto first = triangles.begin(); first != triangles.end();) {
        const std::uint32_t component = componentOf(*first);
        const auto end = std::find_if(first, triangles.end(),
                                      [&](std::uint32_t t) { return componentOf(t) != component; });
        std::vector<TriangleCorners> corners;
        for (auto t = first; t != end; ++t)
            corners.push_back(cornersOf(mesh, *t));
        if (mayCross(std::move(corners))) solid[component] = 0;
        first = end;
    }
    return solid;
}

} // namespace edgeshade
