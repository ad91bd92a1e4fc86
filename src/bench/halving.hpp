#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::bench {

/// What is wrong in one view.
struct ViewErrors {
    std::size_t wrong = 0;
    std::size_t beyond1px = 0; ///< of these, with no boundary near
    std::size_t visible = 0;   ///< pixels
};

/// What was measured of a setting. Frames and views are the same for all settings, in the same
/// order; those that were dropped have the first of them.
struct Evidence {
    std::vector<double> frameMs;
    std::vector<ViewErrors> views;
};

/// Whether one setting takes longer than another and gets more wrong, beyond what more frames and
/// more views could turn round: by certain bounds of the ratio of their times in the same frames,
/// and likewise of their errors view by view, and by the sum of errors, which few views may decide.
/// What gets as much wrong in every one of at least four views draws the same, and longer is
/// enough.
bool isCertainlyDominated(const Evidence& own, const Evidence& other);

/// How much is measured of the settings that are not dropped.
struct Effort {
    int frames = 40;
    int views = 16;
    bool keepsFrames = false; ///< so many, however long that takes
    bool keepsViews = false;
    double seconds = 240.0; ///< that all of it may take, from when the measurer's clock began
};

/// Who measures for halve().
class Measurer {
  public:
    virtual ~Measurer() = default;
    /// Seconds since the beginning.
    virtual double clock() = 0;
    /// Makes what frames or views of these settings take; `who`: ascending indices.
    virtual void prepareFrames(std::span<const std::size_t> who) = 0;
    virtual void prepareViews(std::span<const std::size_t> who) = 0;
    /// Milliseconds of frame `index` of each of them.
    virtual std::vector<double> frame(int index, std::span<const std::size_t> who) = 0;
    virtual std::vector<ViewErrors> view(int index, std::span<const std::size_t> who) = 0;
    /// Told before every frame and view. `share`: of all of them that is done.
    virtual void progress(double share, const std::string& doing) = 0;
};

/// Where a setting stands at the end.
struct Standing {
    Evidence evidence;
    int rounds = 0; ///< in which it was measured
    /// What dominated it early, by index, and is quicker; may have been dropped, too.
    std::optional<std::size_t> dominator;
};

/// Successive halving: measures all of `count` settings a little, drops those that are certainly
/// dominated, and measures what is left further, in rounds of frames and of views, each twice as
/// many as before. First some frames of all are timed, then views are judged, then further frames.
/// Whatever doesn't fit into the time is left out, for all settings alike, but for one frame and
/// one view.
std::vector<Standing> halve(std::size_t count, const Effort& effort, Measurer& measurer);

/// What is known of a setting at the end.
struct Estimate {
    double milliseconds = 0.0; ///< median
    double wrongPercent = 0.0; ///< of visible pixels
    double beyond1pxPercent = 0.0;
    /// What other frames and views are unlikely to exceed: medianBelow(), meanBelow().
    double millisecondsBelow = 0.0;
    double wrongPercentBelow = 0.0;
};

/// The estimates, comparable with each other: of what was dropped, which only had some of the
/// frames and views, times are those of its dominator times the median ratio of the two, errors its
/// dominator's and the difference of the two, over what both had.
std::vector<Estimate> estimatesOf(std::span<const Standing> standings);

} // namespace edgeshade::bench
