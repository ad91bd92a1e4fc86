#pragma once

#include "src/shadow/lights/face_outline.hpp"
#include "src/shadow/lights/light.hpp"

#include <span>

namespace edgeshade {

/// The scene as seen by a light: rays to its points. A point light uses the six faces of a cube
/// around it; a directional light one plane across its direction, where a ray is the point (x, y,
/// 1). Both are turned, so that edges along the world's axes run along no axis of a face.
struct LightView {
    explicit LightView(const Light& light);

    glm::dvec3 rayTo(const glm::dvec3& world) const {
        const glm::dvec3 ray = axes * (world - origin);
        return directional ? glm::dvec3(ray.x, ray.y, 1.0) : ray;
    }
    /// The full extent of a face.
    Outline wholeFace() const {
        const double end = directional ? INFINITY : 1.0;
        return {-end, end, -end, end};
    }

    bool directional;
    glm::dvec3 origin; ///< the place of a point light, or the world's
    double range;      ///< of a point light; casters beyond it shade nothing that it reaches
    glm::dmat3 axes;   ///< from the world to rays; to (x, y, 0) for a directional light
    std::span<const glm::dmat3> faces; ///< one, or six; of tables that stay
};

} // namespace edgeshade
