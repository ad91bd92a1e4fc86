#include "preprocess/volumes/triangle_planes.hpp"

#include "preprocess/base/disjoint_sets.hpp"
#include "preprocess/mesh/components.hpp"
#include "preprocess/mesh/coplanar.hpp"
#include "preprocess/mesh/patch_growth.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// The sine of the angle at its first vertex below which a triangle joins no flat patch: to be
/// coplanar says too little of a plane where three points are almost on a line.
constexpr double thinnest = 1e-6;

/// Triangles of an edge up to which each is compared with each. Edges of larger fans join no
/// patches.
constexpr std::uint32_t largestFan = 64;

struct Facet {
    glm::dvec3 normal{0.0}; ///< as long as twice the area
    bool thin = true;
};

Facet facetOf(const WeldedMesh& mesh, const Triangle& triangle) {
    const glm::dvec3 a(mesh.positions[triangle[0]]);
    const glm::dvec3 ab = glm::dvec3(mesh.positions[triangle[1]]) - a;
    const glm::dvec3 ac = glm::dvec3(mesh.positions[triangle[2]]) - a;
    Facet facet;
    facet.normal = glm::cross(ab, ac);
    const double lengths = glm::length(ab) * glm::length(ac);
    facet.thin = !(glm::length(facet.normal) > thinnest * lengths);
    return facet;
}

/// `across`: along its normal, of any length.
glm::vec4 planeOf(const glm::dvec3& across, const glm::vec3& point) {
    const double length = glm::length(across);
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
    const glm::dvec3 normal = across / length;
    return glm::vec4(glm::dvec4(normal, -glm::dot(normal, glm::dvec3(point))));
}

} // namespace

std::vector<glm::vec4> trianglePlanes(const WeldedMesh& mesh, const EdgeList& edges,
                                      double flatTolerance) {
    std::vector<Facet> facets;
    facets.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        facets.push_back(facetOf(mesh, triangle));

    DisjointSets patches(mesh.triangles.size());
    const auto isFlat = [&](const Edge& edge, const Opposite& p, const Opposite& q) {
        const Facet &f = facets[p.triangle], &g = facets[q.triangle];
        if (f.thin || g.thin || !(glm::dot(f.normal, g.normal) > 0.0)) return false;
        if (directionIn(mesh.triangles[p.triangle], edge) ==
            directionIn(mesh.triangles[q.triangle], edge))
            return false;
        return areCoplanar(mesh.positions[edge.a], mesh.positions[edge.b], mesh.positions[p.vertex],
                           mesh.positions[q.vertex]);
    };
    for (const Edge& edge : edges.edges) {
        if (edge.oppositeCount > largestFan) continue;
        const auto opposites = edges.oppositesOf(edge);
        for (std::size_t i = 0; i < opposites.size(); ++i)
            for (std::size_t j = i + 1; j < opposites.size(); ++j)
                if (isFlat(edge, opposites[i], opposites[j]))
                    patches.unite(opposites[i].triangle, opposites[j].triangle);
    }

    std::vector<std::uint32_t> largest(mesh.triangles.size());
    for (std::uint32_t t = 0; t < facets.size(); ++t)
        largest[t] = t;
    const auto area = [&](std::uint32_t t) { return glm::length(facets[t].normal); };
    for (std::uint32_t t = 0; t < facets.size(); ++t) {
        std::uint32_t& best = largest[patches.find(t)];
        if (area(t) > area(best)) best = t;
    }
    std::vector<std::uint32_t> models(mesh.triangles.size());
    for (std::uint32_t t = 0; t < facets.size(); ++t)
        models[t] = largest[patches.find(t)];
    if (flatTolerance > 0.0) {
        std::vector<glm::dvec3> normals;
        normals.reserve(facets.size());
        for (const Facet& facet : facets)
            normals.push_back(facet.normal);
        growPatches(mesh, edges, normals, flatTolerance, models);
    }
    std::vector<glm::vec4> planes;
    planes.reserve(mesh.triangles.size());
    for (const std::uint32_t model : models)
        planes.push_back(planeOf(facets[model].normal, mesh.positions[mesh.triangles[model][0]]));
    return planes;
}

glm::vec4 trianglePlane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 from(a);
    return planeOf(glm::cross(glm::dvec3(b) - from, glm::dvec3(c) - from), a);
}

} // namespace edgeshade
