#pragma once

#include "src/render/planar/planar_shadow_pass.hpp"
#include "src/render/technique/shadow_technique.hpp"

namespace edgeshade {

/// Casters are projected onto the scene's largest planes.
class PlanarTechnique : public ShadowTechnique {
  public:
    std::size_t stencils(const GpuScene&, const FrameLight&) const override { return 1; }
    std::size_t mark(const MarkTask& task) override {
        const CasterGroupInSlice& of = task.casters;
        return pass_.mark(task.scene, of.view, of.slice, of.source().light);
    }
    bool leavesFacing() const override { return true; }

  private:
    PlanarShadowPass pass_;
};

} // namespace edgeshade
