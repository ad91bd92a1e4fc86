#include "src/plot/hours_sheet.hpp"

#include "src/plot/color_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace edgeshade::plot {
namespace {

// Canvas pixels; a PNG has two along each side of one.
constexpr double margin = 16.0, lineHeight = 17.0, titleHeight = 26.0;
constexpr double gap = 18.0, barWidth = 18.0, legendWidth = 96.0;
constexpr double leastWidth = 330.0, leastBar = 150.0;
constexpr Color ink = 0x222222, faint = 0x666666, frame = 0xBBBBBB;

std::string labelOf(double hours) {
    std::ostringstream text;
    text << hours;
    return text.str();
}

/// Draws the outline of a rectangle.
void outline(Canvas& canvas, const Rectangle& r, Color color) {
    const std::array<Point, 5> corners = {{{r.left, r.top},
                                           {r.right, r.top},
                                           {r.right, r.bottom},
                                           {r.left, r.bottom},
                                           {r.left, r.top}}};
    canvas.line(corners, color, 1.0, false);
}

void drawScale(Canvas& canvas, const HoursSheet& sheet, const Rectangle& bar) {
    const double height = bar.bottom - bar.top;
    const auto at = [&](double hours) { return bar.bottom - height * hours / sheet.most; };
    const int steps = static_cast<int>(2.0 * height);
    for (int i = 0; i < steps; ++i) {
        const double low = static_cast<double>(i) / steps,
                     high = static_cast<double>(i + 1) / steps;
        canvas.rectangle(
            {bar.left, bar.bottom - high * height, bar.right, bar.bottom - low * height},
            evenColor(0.5 * (low + high)));
    }
    outline(canvas, bar, frame);
    const bool marked = sheet.threshold && *sheet.threshold <= sheet.most;
    for (const double tick : scaleTicks(sheet.most)) {
        constexpr double textHeight = 14.0; // the threshold's own label may take this place
        if (marked && std::abs(at(tick) - at(*sheet.threshold)) < textHeight) continue;
        const std::array<Point, 2> mark = {{{bar.right, at(tick)}, {bar.right + 5.0, at(tick)}}};
        canvas.line(mark, ink, 1.0, false);
        canvas.text({bar.right + 9.0, at(tick) + 4.0}, labelOf(tick), {.size = 12.0, .color = ink});
    }
    if (marked) {
        const double y = at(*sheet.threshold);
        const std::array<Point, 2> mark = {{{bar.left - 6.0, y}, {bar.right + 6.0, y}}};
        canvas.line(mark, 0xD01010, 2.0, false);
        canvas.text({bar.right + 9.0, y + 4.0}, labelOf(*sheet.threshold) + " h",
                    {.size = 12.0, .color = 0xD01010, .bold = true});
    }
}

} // namespace

std::vector<double> scaleTicks(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    double step = 0.0;
    for (const double factor : {0.1, 0.2, 0.5, 1.0, 2.0})
        if (step == 0.0 && most / (factor * power) <= 6.0 + 1e-9) step = factor * power;
    std::vector<double> ticks;
    for (int i = 0; i * step <= most * (1.0 + 1e-9); ++i)
        ticks.push_back(std::round(i * step / power * 100.0) / 100.0 * power);
    return ticks;
}

Bytes hoursPng(const HoursSheet& sheet) {
    const double width = 0.5 * sheet.width, height = 0.5 * sheet.height;
    const double head =
        margin + titleHeight + lineHeight * static_cast<double>(sheet.subtitles.size());
    const double barHeight = std::max(height - 2.0 * lineHeight, leastBar);
    const double sheetWidth = std::max(margin + width + gap + legendWidth + margin, leastWidth);
    const double sheetHeight = head + std::max(height, barHeight + 2.0 * lineHeight) + margin;
    const std::unique_ptr<Canvas> canvas = pngCanvas(static_cast<int>(std::ceil(sheetWidth)),
                                                     static_cast<int>(std::ceil(sheetHeight)));
    canvas->text({margin, margin + 14.0}, sheet.title, {.size = 16.0, .color = ink, .bold = true});
    for (std::size_t i = 0; i < sheet.subtitles.size(); ++i)
        canvas->text({margin, margin + titleHeight + 8.0 + lineHeight * static_cast<double>(i)},
                     sheet.subtitles[i], {.size = 12.0, .color = faint});

    const Rectangle picture{margin, head, margin + width, head + height};
    canvas->image(picture, sheet.rgba, sheet.width, sheet.height);
    outline(*canvas,
            {picture.left - 0.5, picture.top - 0.5, picture.right + 0.5, picture.bottom + 0.5},
            frame);

    const double left = picture.right + gap;
    canvas->text({left, head + 11.0}, "hours of sun", {.size = 12.0, .color = ink, .bold = true});
    drawScale(
        *canvas, sheet,
        {left, head + 1.5 * lineHeight, left + barWidth, head + 1.5 * lineHeight + barHeight});
    return canvas->file();
}

} // namespace edgeshade::plot
