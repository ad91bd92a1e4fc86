#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/timing/stage_clock.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/plan/frame_plan.hpp"
#include "src/shadow/scissors/depth_picture.hpp"

namespace edgeshade {

/// Has plane-pair volumes counted around what is visible of their shadows alone, once the depth
/// buffer tells what is visible (docs/method.md, C45).
class ScissorPass {
  public:
    /// Whether the settings ask for it and the GL can. Throws Error(unavailable) where they insist
    /// and it can't.
    static bool isWanted(const RenderSettings& settings, const gl::Capabilities& capabilities);

    ScissorPass(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Changes the counts of a slice whose surfaces' depths are in the current framebuffer. Where
    /// settings leave it open, only those of lights whose volumes take many times as long to fill,
    /// by estimate, as finding the rectangles does. Throws Error(unavailable) where settings insist
    /// and the framebuffer can't be read.
    void scissor(SlicePlan& plan, const std::vector<Material>& materials, const FrameView& view,
                 const DepthSlice& slice, StageClock* clock);

  private:
    bool pays(const LightPlan& light, const FrameView& view, const DepthSlice& slice) const;

    bool always_;
    FillWeights weights_;
    DepthPicture depths_;
};

} // namespace edgeshade
