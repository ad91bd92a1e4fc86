#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/view/frustum.hpp"

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::lab {

/// A triangle of the scene relative to one eye: world axes, origin at the eye, so that triangles
/// near the eye keep their detail anywhere in the world.
struct EyeTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    std::uint32_t batch = 0;
    std::uint32_t firstIndex = 0; ///< of its corners, in Batch::indices
    std::uint32_t material = 0;
    bool casts = true;   ///< blocks light
    bool visible = true; ///< false for BLEND, and for backs that the scene culls
};

/// Its corners in its batch's space, as the scene's floats.
std::array<glm::dvec3, 3> cornersInBatch(const Scene& scene, const EyeTriangle& triangle);

/// Its normal, by the order of its corners; its length is twice the area.
inline glm::dvec3 normalOf(const EyeTriangle& triangle) {
    return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

/// All triangles of the scene relative to the frustum's position, with those of its ground if the
/// eye is above it. `cutoutsCast` as in Question, `castMasked` as in CasterSettings.
std::vector<EyeTriangle> eyeTriangles(const Scene& scene, const Frustum& frustum, bool castMasked,
                                      bool cutoutsCast);

} // namespace edgeshade::lab
