#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The caps of a batch that a point light touches. They cast nothing (docs/method.md, C47).
struct ContactCaps {
    std::vector<std::uint32_t> caps; ///< ascending; empty for nearly all lights
    /// Distance from a plane up to which the shaders treat the light as lying in it; 0 if the light
    /// touches nothing.
    float reach = 0.0f;

    bool anyOf(const RecordRange& range) const;
};

/// Finds the contact caps; reuses the memory of `contacts`. `light`: in the batch's space.
/// `mantissaBits`: precision of the vertex shader's floats.
void findContactCaps(const PlanePairShadow& shadow, const glm::dvec4& light, int mantissaBits,
                     ContactCaps& contacts);

} // namespace edgeshade
