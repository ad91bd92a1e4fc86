#include "src/viewer/section_drawing.hpp"

#include "src/viewer/overlay_drawing.hpp"
#include "src/viewer/section_tool.hpp"

namespace edgeshade::viewer {
namespace {

constexpr OverlayColor face = {80, 170, 235, 150};
constexpr OverlayColor rim = {20, 60, 100, 235};
constexpr OverlayColor arrow = {80, 170, 235, 255};
constexpr OverlayColor cutOutline = {80, 170, 235, 200};
constexpr OverlayColor cutOutlineEdge = {15, 40, 70, 110}; // on a bright background

/// Draws places in the world, if they are in front of the eye.
class SectionPen {
  public:
    SectionPen(OverlayDrawing& drawing, const PictureView& view, double scale)
        : drawing_(drawing), view_(view), scale_(scale) {}

    void line(const glm::dvec3& from, const glm::dvec3& to, double width,
              const OverlayColor& color) {
        if (const auto a = seen(from), b = seen(to); a && b)
            drawing_.line(*a, *b, width * scale_, color);
    }

    /// A disc in the world, with a rim.
    void disc(const SectionHandle& handle) {
        const double pixel = view_.pixelAt(view_.depthOf(handle.place));
        const glm::dvec3 other =
            std::abs(handle.normal.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 right = glm::normalize(glm::cross(other, handle.normal));
        const glm::dvec3 up = glm::cross(handle.normal, right);
        const auto at = [&](int i) {
            const glm::dvec2 way = sectionDisc * scale_ * pixel * OverlayDrawing::around(i);
            return handle.place + right * way.x + up * way.y;
        };
        const auto middle = seen(handle.place);
        for (int i = 0; i < OverlayDrawing::corners; ++i) {
            const auto a = seen(at(i)), b = seen(at(i + 1));
            if (middle && a && b) drawing_.triangle(*middle, *a, *b, face);
            line(at(i), at(i + 1), 2.0, rim);
        }
    }

    void arrowOf(const SectionHandle& handle) {
        const auto from = seen(handle.place), to = seen(arrowTip(handle, view_, scale_));
        if (!from || !to) return;
        for (const auto& [wider, color] : {std::pair(1.5 * scale_, rim), {0.0, arrow}}) {
            drawing_.disc(*from, 5.0 * scale_ + wider, color);
            drawing_.line(*from, *to, 4.0 * scale_ + 2.0 * wider, color);
            const glm::dvec2 way = *to - *from;
            if (glm::length(way) < 2.0 * scale_) continue; // it points along the view
            const glm::dvec2 ahead = way / glm::length(way), aside(-ahead.y, ahead.x);
            const glm::dvec2 tip = *to + (8.0 * scale_ + 2.0 * wider) * ahead;
            const glm::dvec2 back = *to - (4.0 * scale_ + wider) * ahead;
            const glm::dvec2 half = (9.0 * scale_ + 1.5 * wider) * aside;
            drawing_.triangle(tip, back + half, back - half, color);
        }
    }

  private:
    std::optional<glm::dvec2> seen(const glm::dvec3& place) const {
        if (view_.depthOf(place) <= 0.0) return std::nullopt;
        return view_.pixelOf(place);
    }

    OverlayDrawing& drawing_;
    const PictureView& view_;
    double scale_;
};

} // namespace

OverlayTriangles sectionTriangles(const ViewState& state, const Stage& stage) {
    OverlayDrawing drawing;
    if (!state.section) return drawing.triangles;
    const PictureView view = stage.viewOf(state.camera);
    SectionPen pen(drawing, view, stage.pixelRatio);
    for (const glm::dvec4& plane : state.section->planes) {
        const std::vector<glm::dvec3> corners = planeInBox(plane, stage.bounds);
        for (const auto& [width, color] : {std::pair(3.0, cutOutlineEdge), {1.5, cutOutline}})
            for (std::size_t i = 0; i < corners.size(); ++i)
                pen.line(corners[i], corners[(i + 1) % corners.size()], width, color);
    }
    for (const SectionHandle& handle : sectionHandles(*state.section, stage.bounds)) {
        if (view.depthOf(handle.place) <= 0.0) continue;
        pen.disc(handle);
        pen.arrowOf(handle);
    }
    return drawing.triangles;
}

} // namespace edgeshade::viewer
