#include "src/viewer/handle_drawing.hpp"

#include "src/viewer/interaction.hpp"
#include "src/viewer/overlay_drawing.hpp"
#include "src/viewer/sun_following.hpp"

namespace edgeshade::viewer {
namespace {

constexpr OverlayColor lamp = {255, 205, 60, 255};
constexpr OverlayColor outline = {40, 36, 20, 255};
constexpr OverlayColor ring = {255, 255, 255, 235};
constexpr OverlayColor stem = {40, 36, 20, 170};
constexpr OverlayColor stemEdge = {255, 255, 255, 110}; // on a dark background
constexpr OverlayColor splitLine = {255, 255, 255, 220};
constexpr OverlayColor splitEdge = {30, 30, 30, 120};

void drawLamp(OverlayDrawing& drawing, const glm::dvec2& at, bool isSun, bool isChosen,
              double pixel) {
    const double radius = (isSun ? 0.75 : 1.0) * handleRadius * pixel;
    if (isSun)
        for (int i = 0; i < OverlayDrawing::corners; i += 3) {
            const glm::dvec2 way = OverlayDrawing::around(i);
            const double outer = 1.65 * radius;
            drawing.line(at, at + (outer + pixel) * way, 4.5 * pixel, outline);
            drawing.line(at, at + outer * way, 2.5 * pixel, lamp);
        }
    if (isChosen) drawing.circle(at, 2.0 * handleRadius * pixel, 2.0 * pixel, ring);
    drawing.disc(at, radius + 1.5 * pixel, outline);
    drawing.disc(at, radius, lamp);
}

} // namespace

OverlayTriangles handleTriangles(const ViewState& state, const Stage& stage) {
    const LightHandles handles = stage.handles();
    const PictureView view = stage.viewOf(state.camera);
    OverlayDrawing drawing;
    for (std::size_t i = 0; i < state.lights.size(); ++i) {
        if (i == 0 && sunIsDown(state)) continue;
        const Light& light = state.lights[i];
        const auto at = handles.pixelOf(light, view);
        if (!at) continue;
        const bool isSun = light.position.w == 0.0;
        glm::dvec3 foot = handles.middle();
        if (!isSun && !stage.bounds.empty())
            foot = {light.position.x, stage.bounds.low.y, light.position.z};
        if (view.depthOf(foot) > 0.0) {
            drawing.line(view.pixelOf(foot), *at, 3.5 * stage.pixelRatio, stemEdge);
            drawing.line(view.pixelOf(foot), *at, 1.5 * stage.pixelRatio, stem);
        }
        drawLamp(drawing, *at, isSun, i == state.chosenLight, stage.pixelRatio);
    }
    return drawing.triangles;
}

OverlayTriangles splitTriangles(const ViewState& state, const Stage& stage) {
    OverlayDrawing drawing;
    const double x = state.splitAt * stage.width;
    const glm::dvec2 top(x, 0.0), bottom(x, stage.height);
    drawing.line(top, bottom, 4.0 * stage.pixelRatio, splitEdge);
    drawing.line(top, bottom, 2.0 * stage.pixelRatio, splitLine);
    return drawing.triangles;
}

} // namespace edgeshade::viewer
