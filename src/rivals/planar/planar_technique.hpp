#pragma once

#include "src/render/technique/shadow_technique.hpp"
#include "src/rivals/planar/planar_shadow_pass.hpp"

namespace edgeshade {

/// Projects casters onto the scene's largest planes, which no animation moves.
class PlanarTechnique : public ShadowTechnique {
  public:
    /// `planes`: their number, see settings::planes.
    explicit PlanarTechnique(std::size_t planes) : count_(planes) {}

    void prepareScene(const GpuScene& scene, const LoadedScene& loaded) override;
    std::size_t stencils(const GpuScene&, const FrameLight&) const override { return 1; }
    std::size_t mark(const MarkTask& task) override {
        const CasterGroupInSlice& of = task.casters;
        return pass_.mark({task.scene, of.view, of.slice, of.source().light}, planes_);
    }
    bool leavesFacing() const override { return true; }
    void describe(const GpuScene&, const Light&, LightMethod& method) const override;
    std::size_t bytes() const override { return planes_.bytes(); }

  private:
    std::size_t count_;
    PlanarShadowPass pass_;
    ShadowPlanes planes_;
    std::shared_ptr<const int> scene_; ///< the scene of these planes
};

} // namespace edgeshade
