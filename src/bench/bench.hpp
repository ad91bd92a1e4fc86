#pragma once

#include "src/bench/flythrough.hpp"
#include "src/bench/statistics.hpp"
#include "src/gl/span_timer.hpp"
#include "src/render/frame/frame.hpp"

#include "src/render/frame/light_methods.hpp"
#include "src/render/timing/stage_timer.hpp"
#include "src/shadow/plan/fill_cost.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace edgeshade::bench {

/// One way of drawing that is timed.
struct Setting {
    std::string name;
    RenderSettings render;
    std::optional<SidesLayout> layout;        ///< nothing: the best that the GL has
    std::optional<int> depthSlices;           ///< nothing: as many as pay
    std::shared_ptr<const LoadedScene> scene; ///< with other casters; null: measure()'s own
};

/// What is drawn, and how often.
struct Task {
    int width = 1920;
    int height = 1080;
    int samples = 0;
    gl::Limits limits = gl::Limits::device;
    int frames = 120;                         ///< measured, at least 1
    int warmUp = 3;                           ///< frames before, not measured
    std::function<Frustum(double)> frustumAt; ///< after a share 0..1 of the flight
    std::vector<Light> lights;
    bool scattered = false;           ///< they are scatterLights()'
    bool lightMoves = false;          ///< by movedLights(); else shadow maps are drawn once
    double circle = usualCircle;      ///< likewise
    std::optional<double> near;       ///< nothing: fitted to each view
    std::optional<gl::Timing> timing; ///< nothing: bestTiming()
    std::vector<Setting> settings;
};

/// What one setting's frames took.
struct Result {
    std::string name;
    RenderSettings settings; ///< with the layout that was used
    std::vector<double> frameMs;
    StageMs stageMs;            ///< medians, over a quarter of the frames, drawn apart for it
    double planMs = 0.0;        ///< median, on the CPU before drawing; not in frameMs
    std::size_t vertexRuns = 0; ///< a frame's, of shadows alone; median
    /// A frame's, of shadow volumes from plane-pair records counted at the picture's resolution,
    /// for lights without an extent; mean. Else nothing.
    std::optional<FillCost> fill;
    std::size_t sideBytes = 0; ///< on the GPU, of shadows alone
    std::size_t capBytes = 0;
    std::size_t mapBytes = 0;
    std::size_t maskBytes = 0;       ///< of masks of lower resolution
    std::size_t tableBytes = 0;      ///< of lights without shadows
    std::vector<LightMethod> lights; ///< how their shadows were made
    std::size_t lightsReaching = 0;  ///< something that a frame shows; median
    std::size_t lightsShadowed = 0;  ///< of these; median
    double repeated = 1.0; ///< time of the first frames, drawn again at the end, over theirs

    std::size_t bytes() const { return sideBytes + capBytes + mapBytes + maskBytes + tableBytes; }
};

struct Report {
    gl::Capabilities device;
    gl::Timing timing = gl::Timing::finish;
    std::vector<Result> results; ///< one a setting, in their order
};

/// Draws every frame of the flight by every setting in turn, whoever is first changing from frame
/// to frame, in one context. Each frame is timed as a whole; the stages are timed in further
/// frames, half way between two, since timing them holds up the GL. The flight is that of `loaded`,
/// whatever scenes settings have. `progress` gets the share done. Throws Error.
Report measure(const LoadedScene& loaded, const Task& task,
               const std::function<void(double)>& progress);

class Course;

/// The same in pieces: frames of the flight, one by one, by those of the settings that are asked
/// for. No stages.
class Turns {
  public:
    /// Draws the frames that are not measured. `loaded` and `task` must outlive it. Throws Error.
    Turns(const LoadedScene& loaded, const Task& task);
    ~Turns();

    /// Milliseconds of frame `index` of each of `who`, indices of settings, drawn in turn.
    std::vector<double> frame(int index, std::span<const std::size_t> who);

    /// Of the frames so far.
    Report report();

  private:
    std::unique_ptr<Course> course_;
};

} // namespace edgeshade::bench
