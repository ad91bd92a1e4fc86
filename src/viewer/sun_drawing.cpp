#include "src/viewer/sun_drawing.hpp"

#include "src/viewer/overlay_drawing.hpp"

namespace edgeshade::viewer {
namespace {

constexpr OverlayColor way = {255, 205, 60, 255};
constexpr OverlayColor wayEdge = {40, 36, 20, 170};
constexpr OverlayColor groundLine = {255, 255, 255, 120};
constexpr OverlayColor groundEdge = {40, 36, 20, 90};
constexpr OverlayColor needle = {205, 60, 45, 255};

/// Draws places on the sphere around the scene, if they are in front of the eye.
class SpherePen {
  public:
    SpherePen(OverlayDrawing& drawing, const ViewState& state, const Stage& stage)
        : drawing_(drawing), view_(stage.viewOf(state.camera)), handles_(stage.handles()),
          pixel_(stage.pixelRatio) {}

    void line(const glm::dvec3& from, const glm::dvec3& to, double width,
              const OverlayColor& color) {
        const auto a = seen(from), b = seen(to);
        if (a && b) drawing_.line(*a, *b, width * pixel_, color);
    }

    void disc(const glm::dvec3& at, double radius, const OverlayColor& color) {
        if (const auto middle = seen(at)) drawing_.disc(*middle, radius * pixel_, color);
    }

  private:
    /// `place`: relative to the sphere's middle, in radii.
    std::optional<glm::dvec2> seen(const glm::dvec3& place) const {
        const glm::dvec3 at = handles_.middle() + handles_.sphereRadius() * place;
        if (view_.depthOf(at) <= 0.0) return std::nullopt;
        return view_.pixelOf(at);
    }

    OverlayDrawing& drawing_;
    PictureView view_;
    LightHandles handles_;
    double pixel_;
};

void drawHorizon(SpherePen& pen, double north) {
    constexpr int corners = 72;
    const auto at = [&](double degrees, double radius) {
        const double clockwise = glm::radians(degrees + north);
        return radius * glm::dvec3(std::sin(clockwise), 0.0, -std::cos(clockwise));
    };
    for (int i = 0; i < corners; ++i) {
        const double from = 360.0 * i / corners, to = 360.0 * (i + 1) / corners;
        pen.line(at(from, 1.0), at(to, 1.0), 3.0, groundEdge);
        pen.line(at(from, 1.0), at(to, 1.0), 1.0, groundLine);
    }
    const glm::dvec3 tip = at(0.0, 1.12);
    for (const double side : {-4.0, 4.0})
        pen.line(at(side, 0.97), tip, 2.5, needle);
    pen.line(at(-4.0, 0.97), at(4.0, 0.97), 2.5, needle);
}

} // namespace

OverlayTriangles sunTriangles(const SunDay& day, const ViewState& state, const Stage& stage) {
    OverlayDrawing drawing;
    SpherePen pen(drawing, state, stage);
    drawHorizon(pen, state.sun ? state.sun->north : 0.0);
    for (const auto& [width, color] : {std::pair(4.0, wayEdge), std::pair(2.0, way)})
        for (const auto& arc : day.arcs)
            for (std::size_t i = 1; i < arc.size(); ++i)
                pen.line(arc[i - 1].direction, arc[i].direction, width, color);
    for (const auto& arc : day.arcs)
        for (const ArcPoint& point : arc)
            if (point.fullHour) {
                pen.disc(point.direction, 4.0, wayEdge);
                pen.disc(point.direction, 3.0, way);
            }
    return drawing.triangles;
}

} // namespace edgeshade::viewer
