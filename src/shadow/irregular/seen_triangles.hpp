#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Surfaces of a batch, somewhere in the world.
struct PlacedSurfaces {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices; ///< three a triangle
    std::span<const std::uint8_t> casts;    ///< by triangle: 1 for casters, else 0
    glm::dmat4 worldFromBatch{1.0};
    std::uint32_t first = 1; ///< its first triangle's number in SeenTriangles
};

/// Which triangle each pixel of a rectangle of a picture shows.
struct SeenTriangles {
    PixelRectangle area; ///< in the picture, from its lower left
    /// Rows from below; 0 where there is no surface, else a triangle of `surfaces`.
    std::vector<std::uint32_t> numbers;
    std::vector<PlacedSurfaces> surfaces; ///< by number
};

} // namespace edgeshade
