#include "edgeshade/silhouettes.hpp"

#include "preprocess/scene/triangle_mesh.hpp"
#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

struct ShadowCasters::Impl {
    Impl(std::span<const float> positions, std::span<const std::uint32_t> indices)
        : Impl(triangleMesh(positions, indices)) {}
    explicit Impl(const TriangleMesh& mesh);

    int sideOf(std::uint32_t triangle, const glm::dvec4& light) const {
        const double side = glm::dot(glm::dvec4(planes[triangle]), light);
        return (side > 0.0) - (side < 0.0);
    }
    /// 1 if the triangle runs from an edge's lower vertex to its upper one, -1 otherwise.
    int directionOf(const Edge& edge, std::uint32_t triangle) const {
        const Triangle& t = welded.triangles[triangle];
        for (std::size_t i = 0; i < 3; ++i)
            if (t[i] == edge.a && t[(i + 1) % 3] == edge.b) return 1;
        return -1;
    }

    std::size_t triangles; ///< with degenerate ones
    WeldedMesh welded;
    EdgeList edges;
    std::vector<glm::vec4> planes;
    std::vector<std::uint32_t> vertices; ///< by welded vertex, the first of the given vertices
};

ShadowCasters::Impl::Impl(const TriangleMesh& mesh)
    : triangles(mesh.indices.size() / 3), welded(weld(mesh.positions, mesh.indices)),
      edges(buildEdges(welded)), planes(trianglePlanes(welded, edges)),
      vertices(welded.positions.size()) {
    for (std::size_t v = mesh.positions.size(); v-- > 0;) {
        const auto at = std::lower_bound(welded.positions.begin(), welded.positions.end(),
                                         mesh.positions[v], orderedBefore);
        if (at != welded.positions.end() && *at == mesh.positions[v])
            vertices[static_cast<std::size_t>(at - welded.positions.begin())] =
                static_cast<std::uint32_t>(v);
    }
}

namespace {

glm::dvec4 vectorOf(const std::array<double, 4>& light) {
    if (!std::all_of(light.begin(), light.end(), [](double x) { return std::isfinite(x); }))
        throw InputError("A light has a number that is not finite.");
    return {light[0], light[1], light[2], light[3]};
}

} // namespace

ShadowCasters::ShadowCasters(std::span<const float> positions,
                             std::span<const std::uint32_t> indices)
    : impl_(std::make_unique<Impl>(positions, indices)) {}
ShadowCasters::~ShadowCasters() = default;
ShadowCasters::ShadowCasters(ShadowCasters&&) noexcept = default;
ShadowCasters& ShadowCasters::operator=(ShadowCasters&&) noexcept = default;

std::vector<SilhouetteEdge> ShadowCasters::silhouettes(const std::array<double, 4>& light) const {
    const glm::dvec4 at = vectorOf(light);
    std::vector<SilhouetteEdge> found;
    for (const Edge& edge : impl_->edges.edges) {
        int multiplicity = 0;
        for (const Opposite& opposite : impl_->edges.oppositesOf(edge))
            multiplicity +=
                impl_->directionOf(edge, opposite.triangle) * impl_->sideOf(opposite.triangle, at);
        if (multiplicity != 0)
            found.push_back({impl_->vertices[edge.a], impl_->vertices[edge.b], multiplicity});
    }
    return found;
}

std::vector<std::int8_t> ShadowCasters::sides(const std::array<double, 4>& light) const {
    const glm::dvec4 at = vectorOf(light);
    std::vector<std::int8_t> sides(impl_->triangles, 0);
    for (std::uint32_t t = 0; t < impl_->welded.triangles.size(); ++t)
        sides[impl_->welded.source[t]] = static_cast<std::int8_t>(impl_->sideOf(t, at));
    return sides;
}

} // namespace edgeshade
