#pragma once

#include "src/gl/span_timer.hpp"
#include "src/render/timing/stage_clock.hpp"

#include <span>

namespace edgeshade {

/// A frame's milliseconds by stage.
struct StageMs {
    double ambient = 0.0;
    double map = 0.0;
    double silhouette = 0.0; ///< 0 where it was not measured apart
    double rasterise = 0.0;  ///< the volumes without the silhouette
    double lit = 0.0;
};

/// A stage clock that times stages by a SpanTimer, which it shares with nobody meanwhile. Timing
/// holds up the GL, so frames that are timed by stage say little as a whole.
class StageTimer : public StageClock {
  public:
    /// `silhouetteApart`: volumes are drawn twice to tell evaluating from rasterising.
    StageTimer(gl::SpanTimer& timer, bool silhouetteApart)
        : timer_(timer), silhouetteApart_(silhouetteApart) {}

    void enter(FrameStage stage) override { timer_.begin(static_cast<int>(stage)); }
    void leave() override { timer_.end(); }
    bool wantsSilhouette() const override { return silhouetteApart_; }

  private:
    gl::SpanTimer& timer_;
    bool silhouetteApart_;
};

/// Adds a frame's spans up. The silhouette's time was spent once more within the volumes', and is
/// taken off them.
StageMs stageMs(std::span<const gl::SpanTimer::Span> frame);

} // namespace edgeshade
