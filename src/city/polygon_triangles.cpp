#include "src/city/polygon_triangles.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/mesh/tessellation.hpp"

namespace edgeshade::city {
namespace {

/// Newell's normal of a ring, relative to its first corner.
glm::dvec3 normalOf(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        normal += glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return normal;
}

} // namespace

std::vector<std::array<glm::dvec3, 3>>
trianglesOf(const std::vector<std::vector<glm::dvec3>>& rings) {
    if (rings.empty() || rings.front().size() < 3) return {};
    if (rings.size() == 1 && rings.front().size() == 3)
        return {{rings[0][0], rings[0][1], rings[0][2]}};
    const glm::dvec3 normal = normalOf(rings.front());
    if (normal == glm::dvec3(0.0)) return {};
    // Relative to the first corner, which GLU's arithmetic is near to.
    const glm::dvec3 origin = rings.front().front();
    std::vector<std::vector<glm::dvec3>> loops = rings;
    std::vector<glm::dvec3> corners;
    for (std::vector<glm::dvec3>& loop : loops)
        for (glm::dvec3& corner : loop) {
            corner -= origin;
            corners.push_back(origin + corner);
        }
    const std::optional<Tessellation> made = tessellate(loops, normal, WindingRule::odd);
    if (!made) throw Error(ExitStatus::unavailable, "There is no memory to triangulate a polygon.");
    for (const glm::dvec3& corner : made->added)
        corners.push_back(origin + corner);
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (const auto& [a, b, c] : made->triangles)
        triangles.push_back({corners[a], corners[b], corners[c]});
    return triangles;
}

} // namespace edgeshade::city
