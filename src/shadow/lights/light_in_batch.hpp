#pragma once

#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// A light in a batch's space, and how well that is known.
struct LightInBatch {
    glm::dvec4 place;      ///< homogeneous, see placeInObject()
    double rounding = 0.0; ///< the largest distance to the exact place; of a directional light, to
                           ///< a vector in the exact direction

    double length() const { return glm::length(glm::dvec3(place)); }
    /// The same for `place` rounded to floats.
    double floatRounding() const { return rounding + 0x1p-23 * length(); }
};

/// Not finite if the transform has no inverse.
LightInBatch lightInBatch(const Light& light, const glm::dmat4& worldFromBatch);

} // namespace edgeshade
