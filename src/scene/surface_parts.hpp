#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Neighbouring triangles of one material, few enough to be left out together where none is in
/// view, and for 16-bit indices: GLES 2 has others only as an extension.
struct SurfacePart {
    std::size_t material = 0;
    std::vector<std::uint32_t> vertices; ///< of the batch
    std::vector<std::uint16_t> indices;  ///< into `vertices`, three a triangle
};

/// A batch's surfaces in the order of its groups. The same for the same batch.
std::vector<SurfacePart> surfacePartsOf(const Batch& batch);

} // namespace edgeshade
