#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Surfaces of a batch, with their transform to the world.
struct PlacedSurfaces {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices; ///< three per triangle
    std::span<const std::uint8_t> casts;    ///< by triangle: 1 for casters, otherwise 0
    glm::dmat4 worldFromBatch{1.0};
    std::uint32_t first = 1; ///< number of its first triangle in SeenTriangles
};

/// The triangle visible at each pixel of a rectangle of a picture.
struct SeenTriangles {
    PixelRectangle area; ///< in the picture, from its lower left
    /// Rows from below; 0 for no surface, otherwise the number of a triangle of `surfaces`.
    std::vector<std::uint32_t> numbers;
    std::vector<PlacedSurfaces> surfaces; ///< in order of their numbers
};

} // namespace edgeshade
