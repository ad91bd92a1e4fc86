#pragma once

#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/frame_stats.hpp"
#include "src/viewer/input.hpp"
#include "src/viewer/sun_hours.hpp"
#include "src/viewer/view_state.hpp"
#include "src/viewer/viewer_settings.hpp"

#include <memory>
#include <optional>

namespace edgeshade::viewer {

struct ViewerParts;

/// The viewer, the same in a window and in a browser: state, camera and light control, animation,
/// split and debug views. Needs a current GLES 2 / WebGL 1 context with depth and stencil; draws
/// into the framebuffer bound when frame() is called. Has no access to windows and events.
class Viewer {
  public:
    /// Throws Error(unavailable) if the GL lacks something.
    explicit Viewer(const gl::Capabilities& capabilities, const ViewerSettings& settings = {});
    ~Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    /// Shows a scene whole and frames it; `scene` isn't cut. Throws Error; the previous scene then
    /// stays.
    void show(LoadedScene scene);
    bool hasScene() const;

    /// The picture's size in pixels, at least 1x1, and the number of them per CSS or window pixel.
    void resize(int width, int height, double pixelRatio);

    const ViewState& state() const;
    /// Sets the state to `changed(state(), changes)`. Throws as that does, and Error(unavailable)
    /// for settings that the GL can't draw; nothing has changed then.
    void change(const nlohmann::ordered_json& changes);

    void pointerDown(const Pointer& pointer);
    void pointerMove(const Pointer& pointer);
    void pointerUp(const Pointer& pointer);
    /// `notches` > 0: towards the point under (x, y).
    void wheel(double x, double y, double notches);
    void run(Command command);

    /// The file's perspective cameras, in their current poses.
    std::vector<FileCamera> cameras() const;

    /// Names of the scene's animations; the state selects one by index.
    std::vector<std::string> animations() const;

    /// Length of that animation in seconds; 0: nothing moves.
    double animationSeconds() const;

    /// Progress of soft shadows. Shadows of lights with an extent are hard while something moves,
    /// then become soft, frame by frame.
    LightPoints lightPoints() const;

    /// Progress of antialiasing. `shown`: pictures averaged in the last frame, 0 for the usual
    /// picture; `of`: pictures in the end, 0 if the state requests no smoothing.
    LightPoints smoothing() const;

    /// Progress of the hours of sunlight; empty if the state doesn't show them, or nothing was
    /// drawn since. While something moves, the usual picture is shown.
    std::optional<SunHours> sunHours() const;

    /// Whether the last picture shows the hours of sunlight.
    bool showsSunHours() const;

    /// Number of sun positions that light the surface at a pixel, in a picture of hours; x and y as
    /// in Pointer. Empty if the picture shows no hours, or no surface there. Waits for the GL.
    std::optional<std::uint32_t> sunHoursAt(double x, double y) const;

    /// The length of the scene's diagonal; 0: no scene, or one without size.
    double sceneSize() const;

    /// Position, rise and set of the state's sun by place and time, see sun_day.hpp; null if it has
    /// none.
    nlohmann::ordered_json sun() const;

    /// Draws if anything has changed since the last call, including the times of an animation and
    /// of a day; returns whether it drew. Builds primitive maps of resting lights, in the
    /// background or, where there are no threads, for some milliseconds. `now`: seconds on a clock
    /// that only goes forward.
    bool frame(double now);
    /// Makes the next frame() draw, after a change outside, such as of the window's contents.
    void invalidate();
    /// Whether the next frame() would draw, or continue work for a later picture; otherwise a loop
    /// can sleep.
    bool wantsFrame() const;

    /// From the first call on, each frame is timed until it is finished, which keeps the CPU
    /// waiting for the GPU.
    FrameStats stats() const;

    /// Call it after the context was lost: it drops everything on the GPU, and nothing is drawn
    /// until restoreGpu() has recreated it in a new current context. The lost context should still
    /// be current; deleting has no effect in it.
    void forgetGpu();
    /// Throws Error; nothing is on the GPU then.
    void restoreGpu(const gl::Capabilities& capabilities);

  private:
    std::unique_ptr<ViewerParts> parts_;
};

} // namespace edgeshade::viewer
