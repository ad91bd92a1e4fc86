#pragma once

#include "src/scene/gpu_scene.hpp"

namespace edgeshade {

/// Which of a batch's opaque surfaces are of solids.
struct SolidSurfaces {
    static constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> ofTriangle; ///< by opaque triangle, as castingSurfacesOf() has them
    std::vector<Box> bounds;               ///< of each solid, in the batch's space
};

/// Finds them, see solidComponents(). None in a batch that deforms: a pose may cross itself.
SolidSurfaces solidSurfacesOf(const Batch& batch, const std::vector<Material>& materials);

/// Puts the triangles of solids last within each chunk, and says so there; once for a scene.
void sortSolidsLast(GpuScene& gpu, const LoadedScene& loaded);

} // namespace edgeshade
