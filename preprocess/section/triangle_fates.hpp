#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// How a section's planes meet a triangle.
enum class TriangleFate : std::uint8_t {
    kept, ///< all corners are above every plane
    away, ///< each plane has all corners above it or all below it; one has them below
    met,  ///< a plane passes between its corners, or through one
};

/// The fate of each triangle, by heightOver() of its corners. `planes`: in the geometry's space.
std::vector<TriangleFate> fatesOf(const Geometry& geometry, const std::vector<glm::dvec4>& planes);

} // namespace edgeshade
