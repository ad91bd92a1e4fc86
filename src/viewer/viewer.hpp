#pragma once

#include "src/render/frame/light_methods.hpp"
#include "src/render/timing/stage_timer.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/input.hpp"
#include "src/viewer/sun_hours.hpp"
#include "src/viewer/view_state.hpp"

#include <memory>
#include <optional>

namespace edgeshade::viewer {

/// What was measured of the frames drawn lately, and what they were made of. Times are means over
/// the last frames, 0 before the first.
struct FrameStats {
    double frameMs = 0.0;           ///< until the picture was there
    double planMs = 0.0;            ///< of it, on the CPU before drawing
    double poseMs = 0.0;            ///< besides, of one that shows another pose than the last
    std::optional<StageMs> stageMs; ///< of the last frame whose stages were timed, one of 16
    std::size_t triangles = 0;
    std::size_t edges = 0;
    std::size_t records = 0;
    std::size_t silhouettes = 0; ///< records with non-zero multiplicity for the chosen light
    std::size_t shadowBytes = 0;
    std::size_t mapBytes = 0;
    std::size_t primitiveMapBytes = 0;
    std::vector<LightMethod> lights; ///< how each one's shadows are made, on the left
};

/// How far soft shadows are: what each light with an extent is shown by.
struct LightPoints {
    std::size_t shown = 0; ///< points; 0: its centre alone
    std::size_t of = 0;    ///< once nothing has moved for a while; 0: no light has an extent
};

/// {"shown", "of"}.
nlohmann::ordered_json toJson(const LightPoints& points);

/// {"frame_ms", "plan_ms", "pose_ms", "triangles", "edges", "records", "silhouettes",
/// "shadow_bytes",
///  "map_bytes", "primitive_map_bytes", "lights": [{"method", "why", "build_ms", "bytes"}, …],
///  "stage_ms": {"ambient", "map", "silhouette", "rasterise", "lit"}}; the last one
/// once it is known.
nlohmann::ordered_json toJson(const FrameStats& stats);

/// What a viewer draws with beyond what its state can change.
struct ViewerSettings {
    RenderSettings render;             ///< without what SideSettings has, ambient and layout
    std::optional<SidesLayout> layout; ///< nothing: the best that the context has
    DepthChoice depth;
    /// Where primitive maps are built that aren't needed at once; null: by the viewer.
    std::shared_ptr<PrimitiveMapWorker> mapWorker;
    /// chooseLights(), where the window has it; null: all lights are drawn with shadows.
    void (*chooseLights)(FrameView&, std::optional<std::size_t>) = nullptr;
};

/// One viewer, the same in a window and in a browser: state, camera and light control, animation,
/// split and debug views. Needs a current GLES 2 / WebGL 1 context with depth and stencil; draws
/// into the framebuffer bound when frame() is called. Knows nothing of windows and events.
class Viewer {
  public:
    /// Throws Error(unavailable) if the GL can't.
    explicit Viewer(const gl::Capabilities& capabilities, const ViewerSettings& settings = {});
    ~Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    /// Shows a scene and frames it. Throws Error; the scene shown before then stays.
    void show(LoadedScene scene);
    bool hasScene() const;

    /// The picture's size in pixels, at least 1x1, and how many of them a CSS or window pixel has.
    void resize(int width, int height, double pixelRatio);

    const ViewState& state() const;
    /// The state becomes `changed(state(), changes)`. Throws as it does, and Error(unavailable) for
    /// settings that the GL can't draw; nothing is changed then.
    void change(const nlohmann::ordered_json& changes);

    void pointerDown(const Pointer& pointer);
    void pointerMove(const Pointer& pointer);
    void pointerUp(const Pointer& pointer);
    /// `notches` > 0: towards what is under (x, y).
    void wheel(double x, double y, double notches);
    void run(Command command);

    /// The file's cameras in perspective, where they are now.
    std::vector<FileCamera> cameras() const;

    /// Names of the scene's animations; the state says by index which one is shown.
    std::vector<std::string> animations() const;

    /// Length of that animation in seconds; 0: nothing moves.
    double animationSeconds() const;

    /// Shadows of lights with an extent are hard while something moves, and become soft after that,
    /// frame by frame.
    LightPoints lightPoints() const;

    /// How many pictures, sampled here and there within their pixels, the last one is the mean of,
    /// 0: it is the usual one; and of how many it will be, 0: the state asks for none.
    LightPoints smoothing() const;

    /// How far the hours of sun that the state asks for are counted; nothing: it asks for none, or
    /// nothing was drawn since. While something moves, the picture is the usual one.
    std::optional<SunHours> sunHours() const;

    /// Whether the last picture shows them.
    bool showsSunHours() const;

    /// How many of those positions see a pixel of a picture of hours, x and y as a Pointer's.
    /// Nothing: the picture shows none, or no surface there. Waits for the GL.
    std::optional<std::uint32_t> sunHoursAt(double x, double y) const;

    /// The length of the scene's diagonal; 0: no scene, or one without a size.
    double sceneSize() const;

    /// Where the state's sun by place and time is, and when it rises and sets that day, see
    /// sun_day.hpp; null where it has none.
    nlohmann::ordered_json sun() const;

    /// Draws if anything has changed since the last call, the times of an animation and of a day
    /// included; returns whether it drew. Builds primitive maps of lights that rest, in the
    /// background or, where there are no threads, for some milliseconds. `now`: seconds on a clock
    /// that only goes forward.
    bool frame(double now);
    /// Something outside has changed, such as the window's contents: the next frame() draws.
    void invalidate();
    /// Whether the next frame() would draw, or go on with what a later one draws from: else a loop
    /// can sleep.
    bool wantsFrame() const;

    /// From the first call on frames are timed until they are finished, which keeps the CPU waiting
    /// for the GPU.
    FrameStats stats() const;

    /// The context was lost: everything on the GPU is forgotten, and nothing is drawn until
    /// restoreGpu() has made it anew in a context that is current again. The lost context should
    /// still be the current one; deleting has no effect in it.
    void forgetGpu();
    /// Throws Error; there is nothing on the GPU then.
    void restoreGpu(const gl::Capabilities& capabilities);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace edgeshade::viewer
