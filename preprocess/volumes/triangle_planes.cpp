#include "preprocess/volumes/triangle_planes.hpp"

#include "preprocess/base/disjoint_sets.hpp"
#include "preprocess/base/prefetch.hpp"
#include "preprocess/mesh/coplanar.hpp"
#include "preprocess/mesh/patch_growth.hpp"

#include <cmath>
#include <numeric>

namespace edgeshade {
namespace {

/// Sine of the angle at a triangle's first vertex below which it joins no flat patch: coplanarity
/// says too little about the plane of three points that are almost on a line.
constexpr double thinnest = 1e-6;

/// Triangles of an edge up to which all are compared with each other. Edges of larger fans join no
/// patches.
constexpr std::uint32_t largestFan = 64;

struct Facet {
    glm::dvec3 normal{0.0}; ///< its length is twice the area
    bool thin = true;
};

/// Two sides of a triangle, from its first vertex.
struct TwoSides {
    glm::dvec3 ab, ac;

    TwoSides(const WeldedMesh& mesh, const Triangle& triangle) {
        const glm::dvec3 a(mesh.positions[triangle[0]]);
        ab = glm::dvec3(mesh.positions[triangle[1]]) - a;
        ac = glm::dvec3(mesh.positions[triangle[2]]) - a;
    }
    /// Its length is twice the area.
    glm::dvec3 normal() const { return glm::cross(ab, ac); }
};

Facet facetOf(const WeldedMesh& mesh, const Triangle& triangle) {
    const TwoSides sides(mesh, triangle);
    Facet facet;
    facet.normal = sides.normal();
    const double lengths = glm::length(sides.ab) * glm::length(sides.ac);
    facet.thin = !(glm::length(facet.normal) > thinnest * lengths);
    return facet;
}

/// `across`: along the plane's normal, of any length.
glm::vec4 planeOf(const glm::dvec3& across, const glm::vec3& point) {
    const double length = glm::length(across);
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
    const glm::dvec3 normal = across / length;
    return glm::vec4(glm::dvec4(normal, -glm::dot(normal, glm::dvec3(point))));
}

/// Whether the triangles' normals, of unit length and rounded to floats, differ by more than is
/// possible if both lie in one plane and neither is thin.
bool isClearlyBent(const glm::vec4& p, const glm::vec4& q) {
    constexpr float roundings = 1e-5f; // of floats; for doubles, 1e-16 over `thinnest` is far
                                       // smaller
    const glm::vec3 difference = glm::vec3(p) - glm::vec3(q);
    return glm::dot(difference, difference) > roundings * roundings;
}

/// Two coplanar triangles of an edge with the same orientation.
struct FlatPair {
    std::uint32_t p, q;
};

/// The flat pairs, in the order of the edges.
std::vector<FlatPair> flatPairs(const WeldedMesh& mesh, const EdgeList& edges,
                                const std::vector<glm::vec4>& planes, Threads threads) {
    const auto isFlat = [&](const Edge& edge, const Opposite& p, const Opposite& q) {
        if (isClearlyBent(planes[p.triangle], planes[q.triangle])) return false;
        const Facet f = facetOf(mesh, mesh.triangles[p.triangle]);
        const Facet g = facetOf(mesh, mesh.triangles[q.triangle]);
        return !f.thin && !g.thin && glm::dot(f.normal, g.normal) > 0.0 &&
               areCoplanar(mesh.positions[edge.a], mesh.positions[edge.b], mesh.positions[p.vertex],
                           mesh.positions[q.vertex]);
    };
    const auto parts = partsOf(edges.edges.size(), itemsOfThread, threads);
    std::vector<std::vector<FlatPair>> found(parts.size());
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        for (std::size_t e = range.first; e < range.end; ++e) {
            constexpr std::size_t ahead = 8;
            if (e + ahead < range.end) {
                const Edge& later = edges.edges[e + ahead];
                for (const std::uint32_t last : {0u, later.oppositeCount - 1})
                    prefetch(planes[edges.opposites[later.firstOpposite + last].triangle]);
            }
            const Edge& edge = edges.edges[e];
            if (edge.oppositeCount > largestFan) continue;
            const auto opposites = edges.oppositesOf(edge);
            const auto forward = edges.forwardOf(edge);
            for (std::size_t i = 0; i < opposites.size(); ++i)
                for (std::size_t j = i + 1; j < opposites.size(); ++j)
                    if (forward[i] != forward[j] && isFlat(edge, opposites[i], opposites[j]))
                        found[part].push_back({opposites[i].triangle, opposites[j].triangle});
        }
    });
    for (std::size_t part = 1; part < parts.size(); ++part)
        found[0].insert(found[0].end(), found[part].begin(), found[part].end());
    return std::move(found[0]);
}

/// For each triangle the largest triangle of its flat patch.
std::vector<std::uint32_t> largestOf(const WeldedMesh& mesh, const std::vector<FlatPair>& flat) {
    DisjointSets patches(mesh.triangles.size());
    std::vector<double> areas(mesh.triangles.size(), -1.0); // twice the area; only of triangles in
                                                            // patches
    for (const FlatPair& pair : flat) {
        patches.unite(pair.p, pair.q);
        for (const std::uint32_t t : {pair.p, pair.q})
            if (areas[t] < 0.0) areas[t] = glm::length(TwoSides(mesh, mesh.triangles[t]).normal());
    }
    std::vector<std::uint32_t> largest(mesh.triangles.size());
    std::iota(largest.begin(), largest.end(), 0u);
    for (std::uint32_t t = 0; t < largest.size(); ++t) {
        if (areas[t] < 0.0) continue;
        std::uint32_t& best = largest[patches.find(t)];
        if (areas[t] > areas[best]) best = t;
    }
    for (std::uint32_t t = 0; t < largest.size(); ++t)
        if (areas[t] >= 0.0) largest[t] = largest[patches.find(t)];
    return largest;
}

/// Gives the triangles of each flat patch the plane of its largest triangle.
void shareLargest(const WeldedMesh& mesh, const std::vector<FlatPair>& flat,
                  std::vector<glm::vec4>& planes) {
    if (flat.empty()) return;
    const std::vector<std::uint32_t> largest = largestOf(mesh, flat);
    for (std::size_t t = 0; t < planes.size(); ++t)
        planes[t] = planes[largest[t]]; // the largest triangle keeps its own
}

} // namespace

std::vector<glm::vec4> trianglePlanes(const WeldedMesh& mesh, const EdgeList& edges,
                                      double flatTolerance, Threads threads) {
    std::vector<glm::vec4> planes(mesh.triangles.size());
    forEachItem(planes.size(), itemsOfThread, threads, [&](std::size_t t) {
        const Triangle& triangle = mesh.triangles[t];
        planes[t] = planeOf(TwoSides(mesh, triangle).normal(), mesh.positions[triangle[0]]);
    });
    const std::vector<FlatPair> flat = flatPairs(mesh, edges, planes, threads);
    if (flatTolerance <= 0.0) {
        shareLargest(mesh, flat, planes);
        return planes;
    }
    std::vector<glm::dvec3> normals;
    normals.reserve(planes.size());
    for (const Triangle& triangle : mesh.triangles)
        normals.push_back(TwoSides(mesh, triangle).normal());
    std::vector<std::uint32_t> models = largestOf(mesh, flat);
    growPatches(mesh, edges, normals, flatTolerance, models);
    const std::vector<glm::vec4> own = planes;
    for (std::size_t t = 0; t < planes.size(); ++t)
        planes[t] = own[models[t]];
    return planes;
}

glm::vec4 trianglePlane(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 from(a);
    return planeOf(glm::cross(glm::dvec3(b) - from, glm::dvec3(c) - from), a);
}

} // namespace edgeshade
