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
    bool animated = false; ///< an animation can move it: it is in no primitive map
    bool hidden = false;   ///< not drawn and without a shadow: scaled to nothing
    bool ground = false;   ///< see Batch
    /// What its surfaces were uploaded of, for maps whose casters the processor cuts; nothing in
    /// builds that have no such maps.
    CopyOnWrite<Geometry> geometry = {};
    /// Of its own, or of all places of a mesh that is kept once: the first of these owns it.
    std::shared_ptr<std::vector<SurfaceChunk>> surfaces;
    bool owns = true;
    BatchVolumes volumes;
    std::vector<SurfacePart> parts = {};   ///< of `surfaces`, where the batch deforms
    std::optional<AlphaLookup> alpha = {}; ///< in place of its materials', of a host's mesh

    bool mirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
};

/// A scene on the GPU.
struct GpuScene {
    std::vector<GpuBatch> batches;
    OverflowGroups groups;       ///< of its casters, for lights that need them
    PrimitiveMaps primitiveMaps; ///< of lights at rest
    std::vector<Material> materials;
    Textures textures;
    bool castMasked = false;  ///< MASK and BLEND surfaces cast too
    bool cutoutsCast = false; ///< LoadedScene's
    bool seeThrough = false;  ///< some surfaces are BLEND and take light
    bool plain = false; ///< all that its surfaces do is scatter light, see Material::isPlain()
    /// Tells this upload from any other, also from one at the same address later.
    std::shared_ptr<const int> identity = std::make_shared<const int>(0);

    /// Where a batch's surfaces of that material find their alpha.
    AlphaLookup alphaOf(std::size_t batch, std::size_t material) const {
        const std::optional<AlphaLookup>& own = batches[batch].alpha;
        return own ? *own : alphaLookupOf(materials[material], textures);
    }
    /// Whether surfaces of the material cast what is looked up of shadow: in maps.
    bool castsInMaps(const Material& material) const {
        return material.casts(castMasked) || (cutoutsCast && material.alphaMode == AlphaMode::mask);
    }
    /// How many groups the casters of a light come in, as far as they were uploaded: 1 or more.
    std::size_t groupCount(const FrameLight& light, VolumeLayout layout) const;
    /// A batch's shadow data of one of them.
    BatchVolumes& volumesOf(std::size_t batch, const FrameLight& light, VolumeLayout layout,
                            std::size_t group);
    const BatchVolumes& volumesOf(std::size_t batch, const FrameLight& light, VolumeLayout layout,
                                  std::size_t group) const;

    std::size_t shadowBytes() const;
};

/// Uploads the surfaces, and the records that shadow volumes are drawn from, none where none will
/// be drawn. Throws Error(unavailable) if the GL can't.
GpuScene uploadScene(const LoadedScene& loaded, std::optional<VolumeRecords> records,
                     const gl::Capabilities& capabilities);

/// Uploads a batch that deforms in the shape in which the scene has it now.
void uploadShape(GpuScene& gpu, const LoadedScene& loaded, std::size_t batch);

/// Uploads shadow data in a further layout, if they are not there yet. Those of one VolumeLayout
/// are there in one SidesLayout alone.
void addVolumes(GpuScene& gpu, const LoadedScene& loaded, VolumeRecords records);

} // namespace edgeshade
