#include "src/shadow/primitive_map/caster_edges.hpp"

#include <numeric>

namespace edgeshade {

CasterEdges casterEdgesOf(const PlanePairShadow& shadow) {
    std::vector<glm::vec3> corners;
    corners.reserve(3 * shadow.caps.size());
    for (const CapRecord& cap : shadow.caps)
        corners.insert(corners.end(), {cap.a, cap.b, cap.c});
    std::vector<std::uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    CasterEdges casters{weld(corners, indices), {}};
    casters.edges = buildEdges(casters.mesh);
    return casters;
}

} // namespace edgeshade
