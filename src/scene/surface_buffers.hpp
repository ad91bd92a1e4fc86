#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/surface_parts.hpp"

#include <vector>

namespace edgeshade {

/// A visible surface's vertex in its GPU layout; 36 bytes.
struct SurfaceVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 texcoord;
    std::uint8_t color[4]; ///< sRGB, alpha linear
};

/// The GPU vertex of a batch's vertex.
SurfaceVertex surfaceVertexOf(const Batch& batch, std::uint32_t index);

/// More attributes of a vertex, for materials that need them; 40 bytes.
struct SurfaceDetail {
    glm::vec4 tangent;                             ///< w: the bitangent's sign
    glm::vec2 texcoords[mostTexcoordChannels - 1]; ///< of channels after the first
};

/// The details of these vertices of a batch; empty if the material needs none.
std::vector<SurfaceDetail> surfaceDetailsOf(const Batch& batch, const Material& material,
                                            const std::vector<std::uint32_t>& vertices);

/// A SurfacePart on the GPU.
struct SurfaceChunk {
    std::size_t place = 0; ///< its index in the batch
    std::size_t material = 0;
    gl::Buffer vertices; ///< SurfaceVertex
    gl::Buffer details;  ///< SurfaceDetail; empty if the material needs none
    gl::Buffer indices;  ///< 16-bit
    int indexCount = 0;
    bool colored = false;   ///< some vertex isn't white
    bool smooth = false;    ///< some triangle's vertex normals aren't its own
    bool tangents = false;  ///< all vertices have one
    glm::vec3 center{0.0f}; ///< mean of the vertices, in the batch's space
    Box bounds;             ///< in the batch's space
};

/// Uploads a batch's surfaces, in the order of surfacePartsOf().
std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch,
                                         const std::vector<Material>& materials);

/// Uploads the vertices of a deforming batch again. `chunks`: the chunks uploaded from `parts`, its
/// surfacePartsOf().
void uploadShape(const Batch& batch, const std::vector<Material>& materials,
                 const std::vector<SurfacePart>& parts, std::vector<SurfaceChunk>& chunks);

} // namespace edgeshade
