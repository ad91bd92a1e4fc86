#pragma once

#include "src/shadow/lights/face_outline.hpp"
#include "src/shadow/lights/light.hpp"

#include <span>

namespace edgeshade {

/// The scene as seen by a light: rays to its points. A point light uses the six faces of a cube
/// around it; a directional light one plane across its direction, where a ray is the point (x, y,
/// 1).
struct LightView {
    explicit LightView(const Light& light);

    glm::dvec3 rayTo(const glm::dvec3& world) const {
        return directional ? glm::dvec3(glm::dot(across, world), glm::dot(upward, world), 1.0)
                           : world - position;
    }
    /// The full extent of a face.
    Outline wholeFace() const {
        const double end = directional ? INFINITY : 1.0;
        return {-end, end, -end, end};
    }

    bool directional;
    glm::dvec3 position; ///< of a point light
    double range;        ///< of a point light; casters beyond it shade nothing that it reaches
    glm::dvec3 across{0.0}, upward{0.0};
    std::span<const glm::dmat3> faces; ///< one, or six; of tables that stay
};

} // namespace edgeshade
