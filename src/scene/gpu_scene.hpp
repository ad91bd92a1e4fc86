#pragma once

#include "src/scene/load.hpp"
#include "src/scene/shadow_buffers.hpp"
#include "src/scene/surface_buffers.hpp"
#include "src/scene/textures.hpp"

namespace edgeshade {

/// One batch on the GPU.
struct GpuBatch {
    glm::dmat4 worldFromBatch{1.0};
    std::vector<SurfaceChunk> surfaces;
    ShadowBuffers shadow;

    bool mirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
};

/// A scene on the GPU.
struct GpuScene {
    std::vector<GpuBatch> batches;
    std::vector<Material> materials;
    Textures textures;

    std::size_t shadowBytes() const;
};

/// Uploads everything. Throws InputError for broken images, Error(unavailable) if the GL can't.
GpuScene uploadScene(const LoadedScene& loaded, SidesLayout layout,
                     const gl::Capabilities& capabilities);

} // namespace edgeshade
