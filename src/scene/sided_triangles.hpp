#pragma once

#include "src/scene/surface_buffers.hpp"
#include "src/shadow/lights/light_shape.hpp"

#include <limits>

namespace edgeshade {

/// A vertex whose triangles all have a light on the same side; 40 bytes.
struct SidedVertex {
    SurfaceVertex vertex;
    /// 1: the light sees them counter-clockwise; -1: clockwise, or not at all; 2: it grazes them;
    /// 0: some of a light with an extent sees them so, or neither
    float lightSide;
};

/// The triangles of a SurfacePart in their order, and which side a light is on. Order matters: of
/// surfaces in one place the first is seen.
struct SidedTriangles {
    /// Of all of them, which are drawn as they are without a light; 0: of either, and the others
    /// are there.
    float lightSide = 0.0f;
    std::vector<SidedVertex> vertices;  ///< those of triangles on several sides stand for each
    std::vector<SurfaceDetail> details; ///< of the vertices, as far as the material has any
    std::vector<std::uint16_t> indices;

    std::size_t bytes() const {
        return vertices.size() * sizeof(SidedVertex) + details.size() * sizeof(SurfaceDetail) +
               indices.size() * sizeof(std::uint16_t);
    }
};

/// Of every part of a batch, for a light in the batch's space. `extended`: it has an extent.
/// `range`: triangles farther from it, as rangeInObject() has it, say either side.
std::vector<SidedTriangles> sidedTriangles(const Batch& batch,
                                           const std::vector<Material>& materials,
                                           const LightShape& light, bool extended = false,
                                           double range = std::numeric_limits<double>::infinity());

} // namespace edgeshade
