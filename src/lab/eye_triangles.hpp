#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/view/frustum.hpp"

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::lab {

/// A triangle of the scene as seen from one eye: world axes, origin at the eye, so that what is
/// near the eye keeps its detail wherever in the world it is.
struct EyeTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    std::uint32_t batch = 0;
    std::uint32_t firstIndex = 0; ///< of its corners in Batch::indices
    std::uint32_t material = 0;
    bool casts = true;   ///< blocks light
    bool visible = true; ///< can be seen: everything but BLEND and backs that the scene culls
};

/// Its corners in its batch's space: the floats at hand.
std::array<glm::dvec3, 3> cornersInBatch(const Scene& scene, const EyeTriangle& triangle);

/// Its normal, by the order of its corners; as long as twice its area.
inline glm::dvec3 normalOf(const EyeTriangle& triangle) {
    return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

/// All triangles of the scene, `cutoutsCast` as in Question, as seen from the frustum's position;
/// those of its ground if the eye is above it. `castMasked` as in CasterSettings.
std::vector<EyeTriangle> eyeTriangles(const Scene& scene, const Frustum& frustum, bool castMasked,
                                      bool cutoutsCast);

} // namespace edgeshade::lab
