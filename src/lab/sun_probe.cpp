#include "src/lab/sun_probe.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::lab {
namespace {

/// Distance from a plane at which a point counts as on it, as a share of the coordinates nearby: a
/// file's floats are rounded by 2^-24, and typed decimals aren't floats.
constexpr double onPlane = 4e-7;
/// Least cosine between a probe's normal and that of the surface it is on.
constexpr double sameFacing = 0.99;

/// Whether the origin lies on a triangle; `reach`: the size of coordinates nearby.
bool isTouched(const rays::Corners& corners, double reach) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    if (area == 0.0) return false;
    const double tolerance = onPlane * reach;
    if (std::abs(glm::dot(normal, a)) > tolerance * area) return false;
    const auto isInside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 edge = to - from;
        return glm::dot(normal, glm::cross(edge, -from)) >= -tolerance * area * glm::length(edge);
    };
    return isInside(a, b) && isInside(b, c) && isInside(c, a);
}

/// The triangles that a point is on. `place`: of the point, as the triangles' corners are.
std::vector<std::uint32_t> trianglesAt(const Oracle& oracle, const glm::dvec3& point,
                                       const glm::dvec3& place,
                                       const std::optional<glm::dvec3>& normal) {
    const glm::dvec3 size = glm::abs(point);
    const double farthest = std::max({size.x, size.y, size.z});
    std::vector<std::uint32_t> own;
    for (std::uint32_t i = 0; i < oracle.triangles().size(); ++i) {
        const SurfaceTriangle& triangle = oracle.triangles()[i];
        const rays::Corners corners = {triangle.a - place, triangle.b - place, triangle.c - place};
        const double extent =
            std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
        if (!isTouched(corners, std::max(farthest, extent))) continue;
        const glm::dvec3 faces = glm::normalize(normalOf(triangle));
        if (!normal || std::abs(glm::dot(faces, glm::normalize(*normal))) > sameFacing)
            own.push_back(i);
    }
    return own;
}

} // namespace

std::vector<bool> seenFrom(const Oracle& oracle, const glm::dvec3& point,
                           const std::optional<glm::dvec3>& normal,
                           std::span<const glm::dvec3> directions) {
    const glm::dvec3 place = point - oracle.position();
    const std::vector<std::uint32_t> own = trianglesAt(oracle, point, place, normal);
    std::vector<bool> seen;
    for (const glm::dvec3& direction : directions)
        seen.push_back((!normal || glm::dot(*normal, direction) > 0.0) &&
                       oracle.isOpen(place, own, direction));
    return seen;
}

} // namespace edgeshade::lab
