#pragma once

#include "preprocess/scene/scene.hpp"
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

/// Neighbouring triangles of one material, few enough to be left out together where none is in
/// view, and for 16-bit indices: GLES 2 has others only as an extension.
struct SurfaceChunk {
    std::size_t material = 0;
    gl::Buffer vertices; ///< SurfaceVertex
    gl::Buffer indices;  ///< 16-bit
    int indexCount = 0;
    bool colored = false;   ///< some vertex isn't white
    glm::vec3 center{0.0f}; ///< mean of the vertices, in the batch's space
    Box bounds;             ///< in the batch's space
};

/// Uploads a batch's surfaces, in the order of its groups.
std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch);

} // namespace edgeshade
