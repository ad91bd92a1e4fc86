#pragma once

#include "src/viewer/day_clock.hpp"
#include "src/viewer/frame_meter.hpp"
#include "src/viewer/interaction.hpp"
#include "src/viewer/light_rest.hpp"
#include "src/viewer/shown_scene.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/sun_day.hpp"
#include "src/viewer/viewer_gpu.hpp"
#include "src/viewer/viewer_settings.hpp"

namespace edgeshade::viewer {

/// The viewer's internals. Everything on the GPU can be dropped and made again from the rest.
struct ViewerParts {
    ViewerSettings settings;
    ViewState state;
    Stage stage;
    Interaction interaction;
    FrameClock clock;
    DayClock dayClock;
    SunDays sunDays;
    std::optional<ShownScene> shown; ///< empty: no scene
    LightRest rest;
    FrameMeter meter;
    bool mapsPending = false;       ///< a light may get a primitive map soon
    std::unique_ptr<ViewerGpu> gpu; ///< null: the context is lost
    bool dirty = true;
    std::size_t changes = 0; ///< counts changes of the picture, for smoothing
    std::size_t poses = 0;   ///< counts movements and changes of the scene
    bool unchecked = true;   ///< something new is drawn, which the GL may refuse
    bool showsHours = false; ///< whether the last picture shows hours of sunlight

    // viewer_scene.cpp: the scene as the state wants it, here and on the GPU.

    std::unique_ptr<ViewerGpu> makeGpu(const gl::Capabilities& capabilities) const;
    /// The scene on the GPU, or null.
    GpuScene* gpuScene() const { return gpu && gpu->scene ? &*gpu->scene : nullptr; }
    /// Replaces all by another scene, whole and framed. Throws before anything has changed.
    void show(LoadedScene scene);
    /// Prepares everything that the next state needs before switching to it, so that a refusal
    /// changes nothing.
    void adopt(const ViewState& wanted);
    /// Uploads another cut of the scene; empty while the context is lost.
    std::optional<GpuScene> uploadedCut(const LoadedScene& cut, const ViewState& of) const;
    /// Replaces the scene by another cut of it. Maps wait until lights rest in that.
    void showCut(LoadedScene cut, std::optional<GpuScene> uploaded);
    /// Poses batches, cameras and lights by the animation at the state's time.
    void applyPose();
    /// Shows, hides or restyles the ground, which always exists.
    void applyGround();
    /// Makes MASK surfaces cast or not, where shadow is looked up.
    void applyCutouts();
    /// Opposite-vertex records don't distinguish front from back: a side that draws from them shows
    /// all surfaces from both sides. So do cut scenes, whose insides are in view.
    void applyCulling();
    /// Drops everything computed for the batches' old places.
    void sceneMoved();

    // viewer_picture.cpp: pictures of that scene, and the work between two of them.

    /// The view with samples at this offset within the pixels (subpixelOffset()).
    FrameView viewAt(const glm::dvec2& offset) const;
    void draw();
    void drawSides(const FrameView& view, Convergence& convergence, StageClock* stageClock);
    void drawSide(std::size_t side, const FrameView& view, Convergence& convergence,
                  StageClock* stageClock);
    void drawOverlays();
    const SideSettings& sideAt(std::size_t side) const {
        return side == 0 ? state.left : state.right;
    }
    /// Splits the casters into groups that a stencil can count, and prepares the sides' techniques.
    void groupCasters(FrameView& view);
    /// Whether a side tests visible points instead of counting volumes.
    bool asksPoints(const SideSettings& side);
    /// Whether a side counts points for the shadows of lights with an extent.
    bool countsPoints(std::size_t side) const;
    /// Renderers of the sides that do.
    std::array<Renderer*, 2> countingRenderers();
    SeenScene seenScene(const FrameView& view) const;
    CountedScene countedScene(const FrameView& view) const;
    /// Starts, updates or ends the count of hours of sunlight.
    void seeHours(const FrameView& view);

    /// Continues building primitive maps for resting lights, if a side looks them up.
    void advanceMaps(double now);
    /// Counts more points of lights with an extent; requests another frame when they improve the
    /// picture.
    void converge(double now);
    /// Counts more positions of the sun; the last one triggers a redraw.
    void countHours(double now);
    /// Adds another picture to the displayed mean, with its own soft shadows, after the usual
    /// picture has fully converged.
    void smooth(double now);
};

} // namespace edgeshade::viewer
