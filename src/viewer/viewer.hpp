#pragma once

#include "src/viewer/view_state.hpp"

#include <memory>
#include <optional>

namespace edgeshade::viewer {

enum class PointerButton { primary, middle, secondary };

/// A finger, pen or mouse; x and y in picture pixels, rows down. Fingers have ids of their own, so
/// that two of them pinch.
struct Pointer {
    int id = 0;
    double x = 0.0;
    double y = 0.0;
    PointerButton button = PointerButton::primary;
    bool shift = false;
    bool control = false;
};

/// What keys do, whatever keys a platform gives them.
enum class Command {
    orbitLeft, orbitRight, orbitUp, orbitDown,
    panLeft, panRight, panUp, panDown,
    zoomIn, zoomOut,
    fit, reset,
    lightLeft, lightRight, lightUp, lightDown, lightNearer, lightFarther,
    nextLight, addLight, removeLight, toggleSun,
    nextShadows, toggleSplit, splitLeft, splitRight,
    toggleDebug, toggleLights, togglePlaying, slower, faster,
};

/// What was measured of the frames drawn lately; stages are 0 where they were not timed.
struct FrameStats {
    double frameMs = 0.0;
    double planMs = 0.0;   ///< of it, on the CPU before drawing
    std::size_t triangles = 0;
    std::size_t edges = 0;
    std::size_t records = 0;
    std::size_t silhouettes = 0; ///< edges with non-zero multiplicity for the chosen light
    std::size_t shadowBytes = 0;
    std::size_t mapBytes = 0;
};

nlohmann::ordered_json toJson(const FrameStats& stats);

/// One viewer, the same in a window and in a browser: state, camera and light control, animation,
/// split and debug views. Needs a current GLES 2 / WebGL 1 context with depth and stencil; draws
/// into the framebuffer bound when frame() is called. Knows nothing of windows and events.
class Viewer {
  public:
    explicit Viewer(const gl::Capabilities& capabilities);
    ~Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    /// Shows a scene and frames it. Throws Error; the scene shown before then stays.
    void show(LoadedScene scene);
    bool hasScene() const;

    /// The picture's size in pixels, at least 1x1, and how many of them a CSS or window pixel has.
    void resize(int width, int height, double pixelRatio);

    const ViewState& state() const;
    /// The state becomes `changed(state(), changes)`. Throws as it does.
    void change(const nlohmann::ordered_json& changes);

    void pointerDown(const Pointer& pointer);
    void pointerMove(const Pointer& pointer);
    void pointerUp(const Pointer& pointer);
    /// `notches` > 0: towards what is under (x, y).
    void wheel(double x, double y, double notches);
    void run(Command command);

    /// Length of the animation in seconds; 0: nothing moves.
    double animationSeconds() const;

    /// Draws if anything has changed since the last call, an animation's time included; returns
    /// whether it drew. `now`: seconds on a clock that only goes forward.
    bool frame(double now);
    /// Something outside has changed, such as the window's contents: the next frame() draws.
    void invalidate();
    /// Whether the next frame() would draw, so that a loop can sleep.
    bool wantsFrame() const;

    FrameStats stats() const;

    /// The context was lost: everything on the GPU is forgotten without a GL call. restore() makes
    /// it anew in a context that is current again.
    void forgetGpu();
    void restoreGpu(const gl::Capabilities& capabilities);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace edgeshade::viewer
