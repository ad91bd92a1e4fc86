#pragma once

#include "src/render/technique/shadow_technique.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/render/volumes/volume_counter.hpp"

#include <memory>
#include <optional>

namespace edgeshade {

class GrazedSurfaces;

/// Counts shadow volumes in the stencil.
class VolumesTechnique : public ShadowTechnique {
  public:
    /// `volumes`: draws them from the records of one layout.
    VolumesTechnique(std::unique_ptr<VolumeRenderer> volumes, const RenderSettings& settings,
                     const gl::Capabilities& capabilities);
    ~VolumesTechnique() override;

    void beginFrame(const FrameStart& start) override;
    std::size_t stencils(const GpuScene& scene, const FrameLight& light) const override;
    void plan(const GpuScene& scene, const CasterGroupInSlice& casters, CountPlan& plan) override;
    void prepare(const CountPlan& plan, GpuScene& scene,
                 const CasterGroupInSlice& casters) override;
    std::size_t mark(const MarkTask& task) override;
    bool countsInStencil() const override { return true; }
    void countAlone(const MarkTask& task) const override;
    /// Opposite-vertex records and triangles also count where no surface is.
    bool marksEverywhere() const override;

    void beginPrograms(bool directional, bool open) override;
    void forEachProgram(const gl::ProgramVisitor& visit) const override;

    const VolumeRenderer& renderer() const { return *volumes_; }
    std::size_t bytes() const override { return volumes_->bytes(); }

  private:
    std::unique_ptr<VolumeRenderer> volumes_;
    VolumeCounter counter_;
    std::shared_ptr<GrazedSurfaces> grazed_; ///< null if grazed surfaces need no marks
};

} // namespace edgeshade
