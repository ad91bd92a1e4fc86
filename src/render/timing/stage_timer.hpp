#pragma once

#include "src/gl/span_timer.hpp"
#include "src/render/timing/stage_clock.hpp"

#include <span>

namespace edgeshade {

/// A frame's milliseconds by stage.
struct StageMs {
    double ambient = 0.0;
    double map = 0.0;
    double silhouette = 0.0; ///< 0 if it was not measured separately
    double rasterise = 0.0;  ///< the volumes without the silhouette
    double lit = 0.0;
};

/// A stage clock that times stages with a SpanTimer, which nothing else may use meanwhile. Timing
/// stalls the GL, so the total time of such frames says little.
class StageTimer : public StageClock {
  public:
    /// `silhouetteApart`: draw volumes twice, to separate evaluating from rasterising.
    StageTimer(gl::SpanTimer& timer, bool silhouetteApart)
        : timer_(timer), silhouetteApart_(silhouetteApart) {}

    void enter(FrameStage stage) override { timer_.begin(static_cast<int>(stage)); }
    void leave() override { timer_.end(); }
    bool wantsSilhouette() const override { return silhouetteApart_; }

  private:
    gl::SpanTimer& timer_;
    bool silhouetteApart_;
};

/// Adds up a frame's spans. The silhouette's time was spent again within the volumes', and is
/// subtracted from it.
StageMs stageMs(std::span<const gl::SpanTimer::Span> frame);

} // namespace edgeshade
