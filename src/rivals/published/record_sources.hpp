#pragma once

#include "src/scene/record_source.hpp"

namespace edgeshade {

/// Makes opposite-vertex records, as published: caps, and sides with one largest multiplicity for
/// the whole scene.
class OppositeVertexSource : public RecordSource {
  public:
    VolumeLayout layout() const override { return VolumeLayout::oppositeVertices; }
    std::vector<std::shared_ptr<RecordBuffers>> ofScene(const LoadedScene& loaded,
                                                        SidesLayout layout) const override;
    std::shared_ptr<RecordBuffers> ofBatch(const LoadedScene& loaded, const Batch& batch,
                                           SidesLayout layout) const override;
    std::shared_ptr<RecordBuffers> ofGroup(const Batch& batch, const GroupTopology& topology,
                                           bool alphaTested, std::uint32_t largestOppositeCount,
                                           SidesLayout layout) const override;
};

/// Makes records of single triangles, for brute force.
class TriangleSource : public RecordSource {
  public:
    VolumeLayout layout() const override { return VolumeLayout::triangles; }
    std::vector<std::shared_ptr<RecordBuffers>> ofScene(const LoadedScene& loaded,
                                                        SidesLayout layout) const override;
    std::shared_ptr<RecordBuffers> ofBatch(const LoadedScene& loaded, const Batch& batch,
                                           SidesLayout layout) const override;
    std::shared_ptr<RecordBuffers> ofGroup(const Batch& batch, const GroupTopology& topology,
                                           bool alphaTested, std::uint32_t largestOppositeCount,
                                           SidesLayout layout) const override;
};

} // namespace edgeshade
