#include "src/lab/sun_probe.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::lab {
namespace {

/// Distance from a plane at which a point counts as on it, as a share of the coordinates nearby: a
/// file's floats are rounded by 2^-24, and typed decimals aren't floats.
constexpr double onPlane = 4e-7;
/// Least cosine between a probe's normal and that of the surface it is on.
constexpr double sameFacing = 0.99;

/// Whether the origin lies on the triangle; `reach`: the size of coordinates nearby.
bool isTouched(const SurfaceTriangle& triangle, double reach) {
    const glm::dvec3 normal = normalOf(triangle);
    const double area = glm::length(normal);
    if (area == 0.0) return false;
    const double tolerance = onPlane * reach;
    if (std::abs(glm::dot(normal, triangle.a)) > tolerance * area) return false;
    const auto isInside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 edge = to - from;
        return glm::dot(normal, glm::cross(edge, -from)) >= -tolerance * area * glm::length(edge);
    };
    return isInside(triangle.a, triangle.b) && isInside(triangle.b, triangle.c) &&
           isInside(triangle.c, triangle.a);
}

} // namespace

std::vector<bool> seenFrom(const LoadedScene& loaded, const AlphaLookup& alpha,
                           const glm::dvec3& point, const std::optional<glm::dvec3>& normal,
                           std::span<const glm::dvec3> directions) {
    // With the camera at the probe, triangles are relative to it.
    Question question;
    question.scene = &loaded.scene;
    question.castMasked = loaded.settings.castMasked;
    question.cutoutsCast = loaded.cutoutsCast;
    question.frustum.viewFromWorld = glm::translate(glm::dmat4(1.0), -point);
    const Oracle oracle(question, alpha);
    const std::vector<SurfaceTriangle>& triangles = oracle.triangles();

    const glm::dvec3 size = glm::abs(point);
    const double farthest = std::max({size.x, size.y, size.z});
    std::vector<std::uint32_t> own;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const SurfaceTriangle& triangle = triangles[i];
        const double extent =
            std::max({glm::length(triangle.a), glm::length(triangle.b), glm::length(triangle.c)});
        if (!isTouched(triangle, std::max(farthest, extent))) continue;
        const glm::dvec3 faces = glm::normalize(normalOf(triangle));
        if (!normal || std::abs(glm::dot(faces, glm::normalize(*normal))) > sameFacing)
            own.push_back(i);
    }

    std::vector<bool> seen;
    for (const glm::dvec3& direction : directions)
        seen.push_back((!normal || glm::dot(*normal, direction) > 0.0) &&
                       oracle.isOpen(own, direction));
    return seen;
}

} // namespace edgeshade::lab
