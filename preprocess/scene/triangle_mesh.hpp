#pragma once

#include "preprocess/base/error.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Triangles that a caller of the library hands in.
struct TriangleMesh {
    std::vector<glm::vec3> positions;   ///< no NaN, no infinity, no -0
    std::vector<std::uint32_t> indices; ///< three a triangle, below positions.size()
};

/// `positions`: x, y, z a vertex; `indices`: three a triangle. Throws InputError for numbers that
/// don't come in threes, that aren't finite, and for vertices that there aren't.
TriangleMesh triangleMesh(std::span<const float> positions, std::span<const std::uint32_t> indices);

} // namespace edgeshade
