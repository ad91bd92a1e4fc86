#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::bench {

/// Errors in one view.
struct ViewErrors {
    std::size_t wrong = 0;
    std::size_t beyond1px = 0; ///< of these, away from boundaries
    std::size_t visible = 0;   ///< visible pixels
};

/// Measurements of a setting. All settings have the same frames and views in the same order;
/// dropped settings have only the first of them.
struct Evidence {
    std::vector<double> frameMs;
    std::vector<ViewErrors> views;
};

/// Whether one setting certainly takes longer than another and has more wrong pixels, so that more
/// frames and views would not reverse it. It compares by certain bounds of the ratio of times in
/// the same frames, and of the errors view by view, and by the sum of errors, which a few views may
/// decide. Settings with equal errors in each of at least four views draw the same; then taking
/// longer is enough.
bool isCertainlyDominated(const Evidence& own, const Evidence& other);

/// How much to measure of the settings that are not dropped.
struct Effort {
    int frames = 40;
    int views = 16;
    bool keepsFrames = false; ///< measure all of these frames, however long they take
    bool keepsViews = false;
    double seconds = 240.0; ///< total time, from the start of the measurer's clock
};

/// Measures settings for halve().
class Measurer {
  public:
    virtual ~Measurer() = default;
    /// Seconds since the start.
    virtual double clock() = 0;
    /// Prepares frames or views of these settings; `who`: ascending indices.
    virtual void prepareFrames(std::span<const std::size_t> who) = 0;
    virtual void prepareViews(std::span<const std::size_t> who) = 0;
    /// Milliseconds of frame `index` for each of them.
    virtual std::vector<double> frame(int index, std::span<const std::size_t> who) = 0;
    virtual std::vector<ViewErrors> view(int index, std::span<const std::size_t> who) = 0;
    /// Called before every frame and view. `share`: of the whole work done.
    virtual void progress(double share, const std::string& doing) = 0;
};

/// Final result of a setting.
struct Standing {
    Evidence evidence;
    int rounds = 0; ///< rounds in which it was measured
    /// Index of the faster setting that dominated it early, which may have been dropped too.
    std::optional<std::size_t> dominator;
};

/// Successive halving: measures all `count` settings briefly, drops those that are certainly
/// dominated, and measures the rest further, in rounds of frames and of views, each twice as long
/// as the last. First some frames of all are timed, then views are judged, then further frames.
/// Work that doesn't fit into the time is skipped for all settings alike, except for one frame and
/// one view.
std::vector<Standing> halve(std::size_t count, const Effort& effort, Measurer& measurer);

/// Final estimate of a setting.
struct Estimate {
    double milliseconds = 0.0; ///< median
    double wrongPercent = 0.0; ///< of visible pixels
    double beyond1pxPercent = 0.0;
    /// Values that other frames and views are unlikely to exceed: medianBelow(), meanBelow().
    double millisecondsBelow = 0.0;
    double wrongPercentBelow = 0.0;
};

/// Estimates that are comparable with each other. A dropped setting has only some of the frames and
/// views. Its times are its dominator's times the median ratio of the two; its errors are its
/// dominator's plus the difference of the two, each over what both had.
std::vector<Estimate> estimatesOf(std::span<const Standing> standings);

} // namespace edgeshade::bench
