#pragma once

#include "src/render/volumes/volume_renderer.hpp"
#include "src/rivals/published/record_passes.hpp"

namespace edgeshade {

/// Draws shadow volumes from opposite-vertex records: edges with the opposite vertices of their
/// triangles. Draws every edge and every cap of every batch, z-fail.
class OppositeVertexVolumes : public VolumeRenderer {
  public:
    /// `instancing` is required unless the layout is notInstanced. `tints`: for debug views.
    OppositeVertexVolumes(MultiplicityMethod method, SidesLayout layout,
                          std::optional<gl::Instancing> instancing,
                          std::optional<VolumeTints> tints = {});

    void plan(const GpuScene& scene, const CasterGroupInSlice& casters, CountPlan& plan) override;
    void prepare(const CountPlan& plan, GpuScene& scene,
                 const CasterGroupInSlice& casters) override;
    void draw(const VolumeDraw& draw, const DrawnBatch& batch) const override;
    VolumeLayout layout() const override { return VolumeLayout::oppositeVertices; }

  private:
    std::optional<VolumeTints> tints_;
    std::vector<RecordPasses> passes_; ///< two: by isInContact()
};

} // namespace edgeshade
