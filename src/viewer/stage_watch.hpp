#pragma once

#include "src/render/timing/stage_timer.hpp"

#include <chrono>
#include <vector>

namespace edgeshade::viewer {

/// Waits until the GL has drawn. Reads a pixel back, because browsers don't wait in glFinish().
void waitForPicture();

/// Times a frame's stages by waiting at their ends. This works in every window and browser, and
/// slows that frame down.
class StageWatch : public StageClock {
  public:
    void enter(FrameStage stage) override;
    void leave() override;
    bool wantsSilhouette() const override { return true; }

    /// The times measured so far.
    StageMs stages() const { return stageMs(spans_); }

  private:
    std::vector<gl::SpanTimer::Span> spans_;
    FrameStage stage_ = FrameStage::ambient;
    std::chrono::steady_clock::time_point start_;
};

} // namespace edgeshade::viewer
