#pragma once

#include "src/viewer/frame_clock.hpp"
#include "src/viewer/frame_stats.hpp"
#include "src/viewer/stage_watch.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Measures frames from the first query on. One frame in 16 has its stages timed instead; it waits,
/// so it is excluded from the frame times.
class FrameMeter {
  public:
    /// Something to time the next frame's stages; empty: it isn't one of those.
    std::optional<StageWatch> stageWatch() {
        if (requested_ && frames_++ % 16 == 1) return StageWatch();
        return std::nullopt;
    }

    /// Adds a frame whose stages were timed.
    void add(const StageWatch& watch) { stageMs_ = watch.stages(); }
    void addPlanMs(double ms) { planMs_.add(ms); }
    void addFrameMs(double ms) { frameMs_.add(ms); }
    void addPoseMs(double ms) { poseMs_.add(ms); }
    /// Another scene is posed.
    void forgetPoses() { poseMs_ = {}; }

    void request() { requested_ = true; }
    bool isRequested() const { return requested_; }

    /// Fills in the times.
    void describe(FrameStats& stats) const {
        stats.frameMs = frameMs_.mean();
        stats.planMs = planMs_.mean();
        stats.poseMs = poseMs_.mean();
        stats.stageMs = stageMs_;
    }

  private:
    bool requested_ = false;
    int frames_ = 0;
    RecentMean frameMs_, planMs_, poseMs_;
    std::optional<StageMs> stageMs_; ///< of the last frame whose stages were timed
};

} // namespace edgeshade::viewer
