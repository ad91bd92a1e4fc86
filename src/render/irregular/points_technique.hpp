#pragma once

#include "src/render/irregular/irregular_shadow_pass.hpp"
#include "src/render/technique/shadow_technique.hpp"

namespace edgeshade {

/// Tests each visible point for shadow (docs/method.md, C46).
class PointsTechnique : public ShadowTechnique {
  public:
    explicit PointsTechnique(const gl::Capabilities& capabilities) : pass_(capabilities) {}

    void beginSlice() override { pass_.forgetSurfaces(); }
    std::size_t stencils(const GpuScene&, const FrameLight&) const override { return 1; }
    void plan(const GpuScene&, const CasterGroupInSlice&, CountPlan& plan) override {
        plan.clear();
        plan.byPoints = true;
    }
    std::size_t mark(const MarkTask& task) override {
        const CasterGroupInSlice& of = task.casters;
        pass_.mark(task.scene, of.view, of.slice, of.source().light, task.reach, task.area,
                   of.lookedUp);
        return 0;
    }
    std::size_t bytes() const override { return pass_.bytes(); }

  private:
    IrregularShadowPass pass_;
};

} // namespace edgeshade
