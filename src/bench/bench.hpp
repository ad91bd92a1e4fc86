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

/// A way of drawing to time.
struct Setting {
    std::string name;
    RenderSettings render;
    std::optional<SidesLayout> layout;        ///< null: the GL's best
    std::optional<int> depthSlices;           ///< null: as many as pay
    std::shared_ptr<const LoadedScene> scene; ///< a scene with other casters; null: measure()'s
                                              ///< scene
};

/// A measurement: the flight, and how often to draw.
struct Task {
    int width = 1920;
    int height = 1080;
    int samples = 0;
    gl::Limits limits = gl::Limits::device;
    int frames = 120;                         ///< measured, at least 1
    int warmUp = 3;                           ///< frames before those, not measured
    std::function<Frustum(double)> frustumAt; ///< the view after a share 0..1 of the flight
    std::vector<Light> lights;
    bool scattered = false;  ///< the lights come from scatterLights()
    bool lightMoves = false; ///< lights follow movedLights(); otherwise shadow maps are drawn once
    double circle = usualCircle;      ///< radius, see usualCircle
    std::optional<double> near;       ///< null: fitted to each view
    std::optional<gl::Timing> timing; ///< null: bestTiming()
    std::vector<Setting> settings;
};

/// Results of one setting.
struct Result {
    std::string name;
    RenderSettings settings; ///< with the layout in use
    std::vector<double> frameMs;
    StageMs stageMs;     ///< medians, over a quarter of the frames, drawn separately for this
    double planMs = 0.0; ///< median of CPU time before drawing; not in frameMs
    std::size_t vertexRuns = 0; ///< per frame, for shadows only; median
    /// Mean fill per frame of shadow volumes, if they are plane-pair records counted at the
    /// picture's resolution for lights without an extent; otherwise null.
    std::optional<FillCost> fill;
    std::size_t sideBytes = 0; ///< on the GPU, for shadows only
    std::size_t capBytes = 0;
    std::size_t mapBytes = 0;
    std::size_t maskBytes = 0;       ///< masks of lower resolution
    std::size_t tableBytes = 0;      ///< tables of lights without shadows
    std::vector<LightMethod> lights; ///< how their shadows were made
    std::size_t lightsReaching = 0;  ///< lights that reach something visible in a frame; median
    std::size_t lightsShadowed = 0;  ///< those of them with shadows; median
    double repeated = 1.0; ///< time of the first frames drawn again at the end, relative to the
                           ///< first time

    std::size_t bytes() const { return sideBytes + capBytes + mapBytes + maskBytes + tableBytes; }
};

struct Report {
    gl::Capabilities device;
    gl::Timing timing = gl::Timing::finish;
    std::vector<Result> results; ///< one per setting, in order
};

/// Draws every frame of the flight by every setting in one context, in an order that rotates from
/// frame to frame. Each frame is timed as a whole. Stages are timed in additional frames, half way
/// between two, since timing them slows the GL. The flight is that of `loaded`, even for settings
/// with another scene. `progress` receives the share done. Throws Error.
Report measure(const LoadedScene& loaded, const Task& task,
               const std::function<void(double)>& progress);

class Course;

/// As measure(), in pieces: single frames of the flight, by selected settings, without stages.
class Turns {
  public:
    /// Draws the warm-up frames. `loaded` and `task` must outlive it. Throws Error.
    Turns(const LoadedScene& loaded, const Task& task);
    ~Turns();

    /// Milliseconds of frame `index` for each of `who`, indices of settings, drawn in turn.
    std::vector<double> frame(int index, std::span<const std::size_t> who);

    /// The report on the frames so far.
    Report report();

  private:
    std::unique_ptr<Course> course_;
};

} // namespace edgeshade::bench
