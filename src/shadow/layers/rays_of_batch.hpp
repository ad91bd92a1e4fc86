#pragma once

#include "src/shadow/lights/light_view.hpp"

namespace edgeshade {

/// Coordinates on a light's face that are small numbers where its casters are, so that floats hold
/// them well.
struct FaceFrame {
    glm::dvec2 origin{0.0};
    double scale = 1.0; ///< a power of two

    /// A frame in which the outline, if it is finite, lies within [-1, 1].
    static FaceFrame around(const Outline& outline);

    glm::dvec2 to(const glm::dvec2& onFace) const { return (onFace - origin) * scale; }
    glm::dvec2 from(const glm::dvec2& inFrame) const { return inFrame / scale + origin; }
};

/// The affine map from a batch's space to LightView's rays.
struct RaysOfBatch {
    RaysOfBatch() = default;
    RaysOfBatch(const LightView& view, const glm::dmat4& worldFromBatch, double size);

    /// Always the same doubles for the same point: the edges of a vertex meet there.
    glm::dvec3 to(const glm::vec3& point) const { return linear * glm::dvec3(point) + offset; }
    /// The outline of a box on a directional light's face.
    Outline outlineOf(const Box& box) const;
    /// Maps into a frame of a directional light's face from now on.
    void enter(const FaceFrame& frame);

    glm::dmat3 linear{1.0};
    glm::dvec3 offset{0.0};
    double rounding = 0.0; ///< of each component, for points with coordinates up to `size`
    bool mirrors = false;  ///< the batch's transform reverses winding
};

} // namespace edgeshade
