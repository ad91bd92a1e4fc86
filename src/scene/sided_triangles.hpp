#pragma once

#include "src/scene/surface_buffers.hpp"

namespace edgeshade {

/// A vertex whose triangles all have a light on the same side; 40 bytes.
struct SidedVertex {
    SurfaceVertex vertex;
    float lightSide; ///< 1: the light sees them counter-clockwise; -1: clockwise, or not at all
};

/// The triangles of a SurfacePart in their order, and which side a light is on. Order matters: of
/// surfaces in one place the first is seen.
struct SidedTriangles {
    /// Of all of them, which are drawn as they are without a light; 0: of either, and the others
    /// are there.
    float lightSide = 0.0f;
    std::vector<SidedVertex> vertices;  ///< those of triangles on both sides stand twice
    std::vector<SurfaceDetail> details; ///< of the vertices, as far as the material has any
    std::vector<std::uint16_t> indices;
};

/// Of every part of a batch, for a light in the batch's space.
std::vector<SidedTriangles>
sidedTriangles(const Batch& batch, const std::vector<Material>& materials, const glm::dvec4& light);

} // namespace edgeshade
