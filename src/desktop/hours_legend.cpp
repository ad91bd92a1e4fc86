#include "src/desktop/hours_legend.hpp"

#include "src/desktop/text.hpp"
#include "src/plot/color_scale.hpp"
#include "src/viewer/overlay_drawing.hpp"

namespace edgeshade::desktop {
namespace {

constexpr int steps = 64;
constexpr double stepWidth = 3.0, barHeight = 8.0; // times the scale

/// "3 h 20 min"
std::string durationText(std::size_t minutes) {
    const std::string rest = minutes % 60 ? std::to_string(minutes % 60) + " min" : "";
    if (minutes != 0 && minutes < 60) return rest;
    return std::to_string(minutes / 60) + " h" + (rest.empty() ? "" : " " + rest);
}

std::string wordsOf(const viewer::SunHours& hours, bool shown,
                    const std::optional<std::uint32_t>& here) {
    const auto step = static_cast<std::size_t>(hours.step);
    if (hours.of == 0) return "The sun does not rise on this day";
    if (hours.counted < hours.of)
        return "Hours of sun: " + std::to_string(hours.counted) + " of " +
               std::to_string(hours.of) + " sun positions";
    if (!shown) return "Hours of sun: shown when nothing moves";
    const std::string all = durationText(step * hours.of);
    return here ? durationText(step * *here) + " of " + all : "Hours of sun, 0 h to " + all;
}

} // namespace

viewer::OverlayTriangles hoursLegend(const viewer::SunHours& hours, bool shown,
                                     const std::optional<std::uint32_t>& here, float x,
                                     float bottom, float scale) {
    const std::string words = wordsOf(hours, shown, here);
    const float height = textHeight(words, scale);
    viewer::OverlayDrawing drawing;
    drawing.triangles = textTriangles(words, x, bottom - height, scale);
    if (!shown) return drawing.triangles;
    const double top = bottom - height - scale * barHeight;
    for (int i = 0; i < steps; ++i) {
        const plot::Color color = plot::evenColor((i + 0.5) / steps);
        const viewer::OverlayColor of = {static_cast<std::uint8_t>(color >> 16),
                                         static_cast<std::uint8_t>(color >> 8),
                                         static_cast<std::uint8_t>(color), 255};
        const glm::dvec2 from(x + scale * stepWidth * i, top);
        const glm::dvec2 to = from + glm::dvec2(scale * stepWidth, scale * barHeight);
        drawing.triangle(from, {to.x, from.y}, to, of);
        drawing.triangle(from, to, {from.x, to.y}, of);
    }
    return drawing.triangles;
}

} // namespace edgeshade::desktop
