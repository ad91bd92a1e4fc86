#pragma once

#include "src/scene/batch_volumes.hpp"
#include "src/scene/layered_shadow.hpp"
#include "src/scene/load.hpp"
#include "src/scene/surface_buffers.hpp"
#include "src/scene/textures.hpp"

#include <memory>

namespace edgeshade {

/// One batch on the GPU.
struct GpuBatch {
    glm::dmat4 worldFromBatch{1.0};
    bool hidden = false; ///< not drawn and without a shadow: scaled to nothing
    std::vector<SurfaceChunk> surfaces;
    BatchVolumes volumes;

    bool mirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
};

/// A scene on the GPU.
struct GpuScene {
    std::vector<GpuBatch> batches;
    std::vector<Material> materials;
    Textures textures;
    bool castMasked = false; ///< MASK and BLEND surfaces cast too
    /// Tells this upload from any other, also from one at the same address later.
    std::shared_ptr<const int> identity = std::make_shared<const int>(0);

    std::size_t shadowBytes() const;
};

/// Shadow data in groups, each of which a stencil can count: by group, then by batch.
using GroupedShadow = std::vector<std::vector<BatchVolumes>>;

/// Uploads the surfaces, and the records that shadow volumes are drawn from, none where none will
/// be drawn. Throws Error(unavailable) if the GL can't.
GpuScene uploadScene(const LoadedScene& loaded, std::optional<VolumeRecords> records,
                     const gl::Capabilities& capabilities);

/// Uploads shadow data in a further layout, if they are not there yet. Those of one VolumeLayout
/// are there in one SidesLayout alone.
void addVolumes(GpuScene& gpu, const LoadedScene& loaded, VolumeRecords records);

/// Builds and uploads `groupCount` groups of casters; see groupShadow().
GroupedShadow uploadGroups(const LoadedScene& loaded, std::span<const std::uint32_t> groupOf,
                           std::size_t groupCount, VolumeRecords records);

} // namespace edgeshade
