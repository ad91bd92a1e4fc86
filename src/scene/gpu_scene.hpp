#pragma once

#include "src/scene/alpha_lookup.hpp"
#include "src/scene/batch_volumes.hpp"
#include "src/scene/overflow_groups.hpp"
#include "src/scene/primitive_maps.hpp"
#include "src/scene/surface_buffers.hpp"
#include "src/scene/textures.hpp"

#include <memory>

namespace edgeshade {

/// One batch on the GPU.
struct GpuBatch {
    glm::dmat4 worldFromBatch{1.0};
    bool animated = false; ///< an animation can move it, so it is in no primitive map
    bool hidden = false;   ///< scaled to nothing: not drawn, no shadow
    bool ground = false;   ///< see Batch
    /// The uploaded surfaces' geometry, for maps whose casters the processor cuts; empty in builds
    /// without such maps.
    CopyOnWrite<Geometry> geometry = {};
    /// The batch's own, or those of all places of a mesh stored once, where the first batch owns
    /// them.
    std::shared_ptr<std::vector<SurfaceChunk>> surfaces;
    bool owns = true;
    BatchVolumes volumes;
    std::vector<SurfacePart> parts = {};   ///< parts of `surfaces`, if the batch deforms
    std::optional<AlphaLookup> alpha = {}; ///< replaces its materials' lookup; for a host's mesh

    bool mirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
};

/// A scene on the GPU.
struct GpuScene {
    std::vector<GpuBatch> batches;
    OverflowGroups groups;       ///< groups of casters, for lights that need them
    PrimitiveMaps primitiveMaps; ///< of lights at rest
    std::vector<Material> materials;
    Textures textures;
    bool castMasked = false;  ///< MASK and BLEND surfaces cast too
    bool cutoutsCast = false; ///< as in LoadedScene
    bool seeThrough = false;  ///< some surfaces are BLEND and receive light
    bool plain = false;       ///< its surfaces only scatter light, see Material::isPlain()
    /// Identifies this upload, even if a later one has the same address.
    std::shared_ptr<const int> identity = std::make_shared<const int>(0);

    /// How a batch's surfaces of a material get their alpha.
    AlphaLookup alphaOf(std::size_t batch, std::size_t material) const {
        const std::optional<AlphaLookup>& own = batches[batch].alpha;
        return own ? *own : alphaLookupOf(materials[material], textures);
    }
    /// Whether surfaces of the material cast shadows in primitive maps.
    bool castsInMaps(const Material& material) const {
        return material.casts(castMasked) || (cutoutsCast && material.alphaMode == AlphaMode::mask);
    }
    /// Number of groups of a light's casters, as far as uploaded: 1 or more.
    std::size_t groupCount(const FrameLight& light, VolumeLayout layout) const;
    /// A batch's shadow data in one group.
    BatchVolumes& volumesOf(std::size_t batch, const FrameLight& light, VolumeLayout layout,
                            std::size_t group);
    const BatchVolumes& volumesOf(std::size_t batch, const FrameLight& light, VolumeLayout layout,
                                  std::size_t group) const;

    std::size_t shadowBytes() const;
};

/// Uploads the surfaces and, if given, the records from which shadow volumes are drawn. Throws
/// Error(unavailable) if the GL can't.
///
/// `before`: the scene under another section, or null. Textures are shared with it, and so is what
/// belongs to batches whose records it has in the same layout.
GpuScene uploadScene(const LoadedScene& loaded, std::optional<VolumeRecords> records,
                     const gl::Capabilities& capabilities, const GpuScene* before = nullptr);

/// Uploads a deforming batch in its present shape.
void uploadShape(GpuScene& gpu, const LoadedScene& loaded, std::size_t batch);

/// Uploads shadow data in another layout, if missing. A VolumeLayout is present in a single
/// SidesLayout.
void addVolumes(GpuScene& gpu, const LoadedScene& loaded, VolumeRecords records);

} // namespace edgeshade
