#pragma once

#include "src/scene/sides_layout.hpp"
#include "src/settings/choices.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgeshade {

struct Batch;
struct GroupTopology;
struct LoadedScene;

/// One batch's records on the GPU, in a layout that a RecordSource made.
class RecordBuffers {
  public:
    virtual ~RecordBuffers() = default;

    virtual std::size_t sideBytes() const = 0;
    virtual std::size_t capBytes() const = 0; ///< includes the texture coordinates of cutouts
};

/// Makes and uploads records in a layout other than plane pairs.
class RecordSource {
  public:
    virtual ~RecordSource() = default;

    virtual VolumeLayout layout() const = 0;

    /// The records of every batch of a scene; batches that share their geometry share these.
    virtual std::vector<std::shared_ptr<RecordBuffers>> ofScene(const LoadedScene& loaded,
                                                                SidesLayout layout) const = 0;
    /// The records of one batch that deforms, in the shape in which the scene has it now.
    virtual std::shared_ptr<RecordBuffers> ofBatch(const LoadedScene& loaded, const Batch& batch,
                                                   SidesLayout layout) const = 0;

    /// The records of one group of a batch's casters. `alphaTested`: casters may have holes;
    /// `largestOppositeCount`: the most triangles at one edge, over all batches of the group.
    virtual std::shared_ptr<RecordBuffers> ofGroup(const Batch& batch,
                                                   const GroupTopology& topology, bool alphaTested,
                                                   std::uint32_t largestOppositeCount,
                                                   SidesLayout layout) const = 0;
};

/// The records on the GPU, and how they reach the vertex shader.
struct VolumeRecords {
    VolumeLayout volumes = VolumeLayout::planePairs;
    SidesLayout layout = SidesLayout::instanced;
    const RecordSource* source = nullptr; ///< makes them where they are no plane pairs

    auto operator<=>(const VolumeRecords&) const = default;
};

} // namespace edgeshade
