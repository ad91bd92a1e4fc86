#pragma once

namespace edgeshade {

/// The stages of a frame (thesis, 6.3.2). A stage may occur several times: for each light, group of
/// casters and depth slice.
enum class FrameStage {
    ambient,    ///< depth, ambient light, and the light that is drawn with it
    map,        ///< drawing a shadow map; absent while a kept map is still valid
    silhouette, ///< only the volumes' vertex work, see StageClock
    counting,   ///< the whole volumes: the same vertex work again, and rasterising
    lit, ///< removing light in shadow from `ambient`; surfaces lit by further lights; see-through
         ///< surfaces
};

/// Receives a renderer's position within a frame. Stages don't overlap.
class StageClock {
  public:
    virtual ~StageClock() = default;
    virtual void enter(FrameStage stage) = 0;
    virtual void leave() = 0;

    /// Whether volumes are also drawn beforehand into a viewport of a single pixel, with all other
    /// state as it will be. Hardly anything is rasterised, so the time is that of evaluating the
    /// silhouette. The picture stays the same.
    virtual bool wantsSilhouette() const = 0;
};

/// Enters a stage for its lifetime; does nothing without a clock.
class StageScope {
  public:
    StageScope(StageClock* clock, FrameStage stage) : clock_(clock) {
        if (clock_) clock_->enter(stage);
    }
    ~StageScope() {
        if (clock_) clock_->leave();
    }
    StageScope(const StageScope&) = delete;
    StageScope& operator=(const StageScope&) = delete;

  private:
    StageClock* clock_;
};

} // namespace edgeshade
