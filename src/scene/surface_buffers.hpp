#pragma once

#include "preprocess/scene.hpp"
#include "src/gl/objects.hpp"

#include <vector>

namespace edgeshade {

/// One vertex of a visible surface, as the GPU holds it; 36 bytes.
struct SurfaceVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 texcoord;
    std::uint8_t color[4]; ///< sRGB, alpha linear
};

/// Triangles of one material with at most 65,536 vertices, so that 16-bit indices do: GLES 2 has
/// others only as an extension.
struct SurfaceChunk {
    std::size_t material = 0;
    gl::Buffer vertices; ///< SurfaceVertex
    gl::Buffer indices;  ///< 16-bit
    int indexCount = 0;
    glm::vec3 center{0.0f}; ///< mean of the vertices, in the batch's space
};

/// Uploads a batch's surfaces, in the order of its groups.
std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch);

} // namespace edgeshade
