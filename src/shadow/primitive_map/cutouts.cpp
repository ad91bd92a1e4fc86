#include "src/shadow/primitive_map/cutouts.hpp"

namespace edgeshade {

CutoutPlanes cutoutPlanesOf(const CutoutTriangle& triangle, const std::array<glm::dvec3, 3>& rays) {
    // dot(plane, rays[i]) = value i.
    const glm::dmat3 planeFromValues =
        glm::inverse(glm::transpose(glm::dmat3(rays[0], rays[1], rays[2])));
    const auto planeOf = [&](glm::length_t i) {
        return planeFromValues *
               glm::dvec3(triangle.corners[0][i], triangle.corners[1][i], triangle.corners[2][i]);
    };
    return {planeOf(0), planeOf(1), planeOf(2), triangle.material};
}

} // namespace edgeshade
