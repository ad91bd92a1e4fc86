#include "src/viewer/handle_drawing.hpp"

#include "src/viewer/interaction.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace edgeshade::viewer {
namespace {

using Color = std::array<std::uint8_t, 4>;

constexpr Color lamp = {255, 205, 60, 255};
constexpr Color outline = {40, 36, 20, 255};
constexpr Color ring = {255, 255, 255, 235};
constexpr Color stem = {40, 36, 20, 170};
constexpr Color stemEdge = {255, 255, 255, 110}; // on dark ground
constexpr Color splitLine = {255, 255, 255, 220};
constexpr Color splitEdge = {30, 30, 30, 120};

class Drawing {
  public:
    void triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                  const Color& color) {
        for (const glm::dvec2& corner : {a, b, c})
            triangles.push_back({glm::vec2(corner), {color[0], color[1], color[2], color[3]}});
    }

    void line(const glm::dvec2& from, const glm::dvec2& to, double width, const Color& color) {
        const glm::dvec2 way = to - from;
        if (glm::length(way) == 0.0) return;
        const glm::dvec2 across = 0.5 * width * glm::dvec2(-way.y, way.x) / glm::length(way);
        triangle(from - across, from + across, to + across, color);
        triangle(from - across, to + across, to - across, color);
    }

    void disc(const glm::dvec2& middle, double radius, const Color& color) {
        for (int i = 0; i < corners; ++i)
            triangle(middle, middle + radius * around(i), middle + radius * around(i + 1), color);
    }

    void circle(const glm::dvec2& middle, double radius, double width, const Color& color) {
        for (int i = 0; i < corners; ++i)
            line(middle + radius * around(i), middle + radius * around(i + 1), width, color);
    }

    static glm::dvec2 around(int corner) {
        const double angle = glm::two_pi<double>() * corner / corners;
        return {std::cos(angle), std::sin(angle)};
    }

    static constexpr int corners = 24;
    OverlayTriangles triangles;
};

void drawLamp(Drawing& drawing, const glm::dvec2& at, bool isSun, bool isChosen, double pixel) {
    const double radius = (isSun ? 0.75 : 1.0) * handleRadius * pixel;
    if (isSun)
        for (int i = 0; i < Drawing::corners; i += 3) {
            const glm::dvec2 way = Drawing::around(i);
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
    Drawing drawing;
    for (std::size_t i = 0; i < state.lights.size(); ++i) {
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
    Drawing drawing;
    const double x = state.splitAt * stage.width;
    const glm::dvec2 top(x, 0.0), bottom(x, stage.height);
    drawing.line(top, bottom, 4.0 * stage.pixelRatio, splitEdge);
    drawing.line(top, bottom, 2.0 * stage.pixelRatio, splitLine);
    return drawing.triangles;
}

} // namespace edgeshade::viewer
