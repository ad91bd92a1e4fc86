#pragma once

#include "src/scene/surface_buffers.hpp"
#include "src/shadow/lights/light_shape.hpp"

#include <limits>

namespace edgeshade {

/// A vertex whose triangles are all on the same side of a light; 40 bytes.
struct SidedVertex {
    SurfaceVertex vertex;
    /// 1: the light sees them counter-clockwise; -1: clockwise, or not at all; 2: it grazes them;
    /// 0: for a light with an extent only part of it sees them so, or neither side is certain
    float lightSide;
};

/// The triangles of a SurfacePart in their order, by their side of a light. Order matters: of
/// coinciding surfaces the first is visible.
struct SidedTriangles {
    /// The common side of all triangles, which are then drawn from the plain vertices; 0: sides
    /// differ, and the vectors below are filled.
    float lightSide = 0.0f;
    std::vector<SidedVertex> vertices;  ///< a vertex of triangles on several sides is repeated for
                                        ///< each
    std::vector<SurfaceDetail> details; ///< of the vertices, if the material has any
    std::vector<std::uint16_t> indices;

    std::size_t bytes() const {
        return vertices.size() * sizeof(SidedVertex) + details.size() * sizeof(SurfaceDetail) +
               indices.size() * sizeof(std::uint16_t);
    }
};

/// The triangles of every part of a batch, for a light in the batch's space. `extended`: it has an
/// extent. `range`: as of rangeInObject(); triangles beyond it may get any side.
std::vector<SidedTriangles> sidedTriangles(const Batch& batch,
                                           const std::vector<Material>& materials,
                                           const LightShape& light, bool extended = false,
                                           double range = std::numeric_limits<double>::infinity());

} // namespace edgeshade
