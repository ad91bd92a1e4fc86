#pragma once

#include "src/render/timing/stage_timer.hpp"

#include <chrono>
#include <vector>

namespace edgeshade::viewer {

/// Waits until the GL has drawn. glFinish is not waited for in browsers, a read-back is.
void waitForPicture();

/// Times a frame's stages by waiting at their ends, which works in every window and browser and
/// makes that frame slower.
class StageWatch : public StageClock {
  public:
    void enter(FrameStage stage) override;
    void leave() override;
    bool wantsSilhouette() const override { return true; }

    /// What was timed so far.
    StageMs stages() const { return stageMs(spans_); }

  private:
    std::vector<gl::SpanTimer::Span> spans_;
    FrameStage stage_ = FrameStage::ambient;
    std::chrono::steady_clock::time_point start_;
};

} // namespace edgeshade::viewer
