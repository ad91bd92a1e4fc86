#pragma once

namespace edgeshade {

/// The stages of a frame (thesis, 6.3.2). A stage can come several times: for each light, group of
/// casters and depth slice.
enum class FrameStage {
    ambient,    ///< depth, ambient light, and the light that is drawn with it
    map,        ///< drawing a shadow map; nothing while a kept one is still right
    silhouette, ///< the volumes' vertex work alone, see StageClock
    volumes,    ///< the volumes as they are: that vertex work again, and rasterising
    lit, ///< shadow taken from the light in `ambient`; surfaces lit by others; see-through ones
};

/// Is told by a renderer where in a frame it is. Stages don't overlap.
class StageClock {
  public:
    virtual ~StageClock() = default;
    virtual void enter(FrameStage stage) = 0;
    virtual void leave() = 0;

    /// Whether volumes are to be drawn once more, before, with everything but the viewport as it
    /// will be: that is a single pixel, so nothing worth mentioning is rasterised and what is left
    /// is evaluating the silhouette. The picture stays the same.
    virtual bool wantsSilhouette() const = 0;
};

/// A stage for as long as it lives; nothing where there is no clock.
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
