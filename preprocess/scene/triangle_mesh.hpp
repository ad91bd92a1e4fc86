#pragma once

#include "preprocess/base/error.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Triangles from a caller of the library.
struct TriangleMesh {
    std::vector<glm::vec3> positions;   ///< no NaN, no infinity, no -0
    std::vector<std::uint32_t> indices; ///< three per triangle, below positions.size()
};

/// `positions`: x, y, z per vertex; `indices`: three per triangle. Throws InputError for lengths
/// that aren't multiples of three, numbers that aren't finite, and indices out of range.
TriangleMesh triangleMesh(std::span<const float> positions, std::span<const std::uint32_t> indices);

} // namespace edgeshade
