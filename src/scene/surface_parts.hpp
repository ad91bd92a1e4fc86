#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Neighbouring triangles of one material: few enough to be culled together, and for 16-bit
/// indices, as GLES 2 has larger ones only as an extension.
struct SurfacePart {
    std::size_t material = 0;
    std::vector<std::uint32_t> vertices; ///< indices in the batch
    std::vector<std::uint16_t> indices;  ///< into `vertices`, three per triangle
};

/// A batch's surfaces in the order of its groups; deterministic.
std::vector<SurfacePart> surfacePartsOf(const Batch& batch);

} // namespace edgeshade
