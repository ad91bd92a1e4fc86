#include "src/shadow/lights/face_outline.hpp"

#include "src/shadow/geometry/polygon.hpp"

namespace edgeshade {
std::array<glm::dmat3, 6> directionFaces() {
    std::array<glm::dmat3, 6> faces;
    for (glm::length_t i = 0; i < 6; ++i) {
        const glm::length_t axis = i / 2;
        glm::dmat3 face(0.0);
        face[0][(axis + 1) % 3] = 1.0;
        face[1][(axis + 2) % 3] = 1.0;
        face[2][axis] = i % 2 == 0 ? 1.0 : -1.0;
        faces[static_cast<std::size_t>(i)] = face;
    }
    return faces;
}

FacePolygon polygonOn(const glm::dmat3& face, const std::array<glm::dvec3, 3>& rays) {
    Polygon polygon;
    std::size_t behind = 0, near = 0;
    for (const glm::dvec3& ray : rays) {
        const glm::dvec3 on = ray * face;
        polygon.add(on);
        const double across = std::max(std::abs(on.x), std::abs(on.y));
        behind += on.z < -1e-9 * across;
        near += on.z <= 1e-3 * across;
    }
    FacePolygon result;
    if (behind == 3) return result;
    if (near > 0) {
        // Slightly wider than the face, so that rounding loses nothing.
        for (const glm::dvec3& plane : {glm::dvec3(1.0, 0.0, 1.001), glm::dvec3(-1.0, 0.0, 1.001),
                                        glm::dvec3(0.0, 1.0, 1.001), glm::dvec3(0.0, -1.0, 1.001)})
            polygon = clipped(polygon, plane);
    }
    for (std::size_t c = 0; c < polygon.count; ++c) {
        const glm::dvec3& corner = polygon.corners[c];
        if (corner.z > 0.0) {
            result.add(glm::dvec2(corner) / corner.z);
            continue;
        }
        result = {};
        for (const glm::dvec2& at : {glm::dvec2(-2, -2), {2, -2}, {2, 2}, {-2, 2}})
            result.add(at);
        return result;
    }
    return result;
}

} // namespace edgeshade
