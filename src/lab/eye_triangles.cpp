#include "src/lab/eye_triangles.hpp"

#include "src/shadow/view/visible_depth.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::lab {

namespace {

/// Whether the eye, homogeneous and relative to the frustum's position, is behind the triangle.
bool isSeenFromBehind(const EyeTriangle& triangle, const glm::dvec4& eye, bool mirrored) {
    const double side = glm::dot(normalOf(triangle), glm::dvec3(eye) - triangle.a * eye.w);
    return (mirrored ? -side : side) < 0.0;
}

} // namespace

std::array<glm::dvec3, 3> cornersInBatch(const Scene& scene, const EyeTriangle& triangle) {
    const Geometry& geometry = *scene.batches[triangle.batch].geometry;
    const auto corner = [&](std::uint32_t i) {
        return glm::dvec3(geometry.positions[geometry.indices[triangle.firstIndex + i]]);
    };
    return {corner(0), corner(1), corner(2)};
}

std::vector<EyeTriangle> eyeTriangles(const Scene& scene, const Frustum& frustum, bool castMasked,
                                      bool cutoutsCast) {
    std::vector<EyeTriangle> triangles;
    triangles.reserve(scene.triangleCount());
    const glm::dvec4 eyePlace = frustum.eye();
    const glm::dvec4 eye(glm::dvec3(eyePlace) - frustum.position() * eyePlace.w, eyePlace.w);
    for (std::uint32_t b = 0; b < scene.batches.size(); ++b) {
        const Batch& batch = scene.batches[b];
        if (batch.ground && !isAboveGround(frustum, batch)) continue;
        const glm::dmat4 eyeFromBatch =
            glm::translate(glm::dmat4(1.0), -frustum.position()) * batch.worldFromBatch;
        const auto corner = [&](std::uint32_t index) {
            return glm::dvec3(
                eyeFromBatch *
                glm::dvec4(batch.geometry->positions[batch.geometry->indices[index]], 1.0));
        };
        for (const SurfaceGroup& group : batch.geometry->groups) {
            const Material& material = scene.materials[group.material];
            for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount;
                 i += 3) {
                EyeTriangle& triangle = triangles.emplace_back(
                    EyeTriangle{corner(i), corner(i + 1), corner(i + 2), b, i,
                                static_cast<std::uint32_t>(group.material),
                                material.casts(castMasked) ||
                                    (cutoutsCast && material.alphaMode == AlphaMode::mask),
                                material.alphaMode != AlphaMode::blend});
                if (scene.culls && !material.doubleSided &&
                    isSeenFromBehind(triangle, eye, batch.isMirrored()))
                    triangle.visible = false;
            }
        }
    }
    return triangles;
}

} // namespace edgeshade::lab
