#include "src/plot/trade_plot.hpp"

#include "src/plot/labels.hpp"
#include "src/plot/log_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace edgeshade::plot {
namespace {

constexpr Rectangle plotArea{86.0, 94.0, tradePlotWidth - 190.0, tradePlotHeight - 66.0};
constexpr Color textColor = 0x222222, grey = 0x666666, gridColor = 0xE4E4E4;
constexpr double nameSize = 12.0, radius = 5.0;

/// The mark of a family.
struct Style {
    Color color;
    Shape shape;
};

/// Families with the same colour differ in shape, and the other way round.
Style styleOf(std::size_t family) {
    constexpr std::array<Color, 17> colors = {
        0x2471A3, 0x7D3C98, 0x148F77, 0x5DADE2, 0x1E8449, 0xC0392B, 0xE67E22, 0xB7950B, 0xCB4394,
        0x6E2C00, 0x34495E, 0xF1948A, 0x777777, 0x4A235A, 0xD4AC0D, 0x0B5345, 0xEC407A};
    return {colors[family % colors.size()],
            static_cast<Shape>(family % static_cast<std::size_t>(shapeCount))};
}

/// The text shown when the pointer rests on a point.
std::string hoverOf(const TradePoint& point) {
    std::ostringstream text;
    text << point.name << std::setprecision(3) << "\n"
         << point.milliseconds << " ms, " << point.wrongPercent << " % wrong, "
         << static_cast<double>(point.bytes) / (1 << 20) << " MB on the GPU";
    if (!point.note.empty()) text << "\n" << point.note;
    return text.str();
}

/// The axes: x in milliseconds, y in percent, and the place of 0 percent.
struct Axes {
    LogAxis x, y;
    double zero; ///< y in pixels
    bool hasZero;
};

Axes axesFor(const std::vector<TradePoint>& points) {
    double fastest = INFINITY, slowest = 0.0, fewest = INFINITY, most = 0.0;
    bool hasZero = false;
    for (const TradePoint& point : points) {
        if (point.milliseconds > 0.0) fastest = std::min(fastest, point.milliseconds);
        slowest = std::max(slowest, point.milliseconds);
        most = std::max(most, point.wrongPercent);
        hasZero = hasZero || point.wrongPercent == 0.0;
        if (point.wrongPercent > 0.0) fewest = std::min(fewest, point.wrongPercent);
    }
    if (!std::isfinite(fastest)) fastest = slowest = 1.0; // all are below the clock's resolution
    if (!std::isfinite(fewest)) fewest = most = 1.0;      // no setting has wrong pixels
    const double below = std::pow(10.0, std::floor(std::log10(fewest)));
    const double above = std::max(1.6 * most, 10.0 * below);
    const double bottom = hasZero ? plotArea.bottom - 40.0 : plotArea.bottom;
    return {LogAxis(fastest / 1.35, slowest * 1.6, plotArea.left, plotArea.right),
            LogAxis(below, above, bottom, plotArea.top), plotArea.bottom - 8.0, hasZero};
}

void drawGrid(Canvas& canvas, const Axes& axes, const std::string& timeLabel) {
    const TextStyle below{11.0, grey, Anchor::middle}, beside{11.0, grey, Anchor::end};
    for (const double tick : axes.x.ticks()) {
        const double x = axes.x.at(tick);
        canvas.line(std::array{Point{x, plotArea.top}, Point{x, plotArea.bottom}}, gridColor, 1.0,
                    false);
        canvas.text({x, plotArea.bottom + 18.0}, tickLabel(tick), below);
    }
    for (const double tick : axes.y.ticks()) {
        const double y = axes.y.at(tick);
        canvas.line(std::array{Point{plotArea.left, y}, Point{plotArea.right, y}}, gridColor, 1.0,
                    false);
        canvas.text({plotArea.left - 8.0, y + 4.0}, tickLabel(tick), beside);
    }
    if (axes.hasZero) {
        canvas.line(std::array{Point{plotArea.left, axes.zero}, Point{plotArea.right, axes.zero}},
                    gridColor, 1.0, true);
        canvas.text({plotArea.left - 8.0, axes.zero + 4.0}, "0", beside);
    }
    canvas.line(std::array{Point{plotArea.left, plotArea.top},
                           Point{plotArea.left, plotArea.bottom},
                           Point{plotArea.right, plotArea.bottom}},
                textColor, 1.2, false);
    canvas.text({0.5 * (plotArea.left + plotArea.right), plotArea.bottom + 46.0}, timeLabel,
                {13.0, textColor, Anchor::middle});
    canvas.text({24.0, 0.5 * (plotArea.top + plotArea.bottom)},
                "wrong pixels, percent of visible pixels",
                {13.0, textColor, Anchor::middle, false, true});
}

/// Draws the families in the plot, in a column beside the plot.
void drawLegend(Canvas& canvas, const TradePlot& plot) {
    const double x = plotArea.right + 22.0;
    double y = plotArea.top + 6.0;
    const auto entry = [&](const std::string& text, Shape shape, Color fill, Color rim) {
        canvas.mark({x, y - 4.0}, shape, radius, fill, rim, {});
        canvas.text({x + 13.0, y}, text, {12.0, textColor});
        y += 21.0;
    };
    for (std::size_t family = 0; family < plot.families.size(); ++family) {
        const auto isOfIt = [&](const TradePoint& point) { return point.family == family; };
        if (std::ranges::none_of(plot.points, isOfIt)) continue;
        const Style style = styleOf(family);
        entry(plot.families[family], style.shape, style.color, style.color);
    }
    y += 12.0;
    entry("filled: on the Pareto front", Shape::disc, grey, grey);
    entry("hollow: dominated", Shape::disc, 0xFFFFFF, grey);
}

} // namespace

void drawTradePlot(Canvas& canvas, const TradePlot& plot) {
    const Axes axes = axesFor(plot.points);
    canvas.text({plotArea.left, 30.0}, plot.title, {17.0, textColor, Anchor::start, true});
    canvas.text({plotArea.left, 50.0}, plot.subtitle, {12.0, grey});
    drawLegend(canvas, plot);
    drawGrid(canvas, axes, plot.timeLabel);

    // Points of the front come first, so that their names get the best places.
    std::vector<TradePoint> points = plot.points;
    std::stable_sort(points.begin(), points.end(), [](const TradePoint& a, const TradePoint& b) {
        return std::pair(!a.front, a.milliseconds) < std::pair(!b.front, b.milliseconds);
    });
    std::vector<Point> places, front;
    for (const TradePoint& point : points) {
        const double y = point.wrongPercent > 0.0 ? axes.y.at(point.wrongPercent) : axes.zero;
        places.push_back({std::max(plotArea.left, axes.x.at(point.milliseconds)), y});
        if (point.front) front.push_back(places.back());
    }
    if (front.size() > 1) canvas.line(front, 0x999999, 1.5, true);

    LabelPlaces labels(plotArea, places, radius);
    labels.keepOff(front);
    for (std::size_t i = 0; i < front.size(); ++i) {
        // for bold text
        const double width = 0.68 * nameSize * static_cast<double>(points[i].name.size());
        const Rectangle name = labels.place(places[i], width, 1.1 * nameSize);
        const Point nearest{std::clamp(places[i].x, name.left, name.right),
                            std::clamp(places[i].y, name.top, name.bottom)};
        if (std::hypot(nearest.x - places[i].x, nearest.y - places[i].y) > 3.5 * radius)
            canvas.line(std::array{places[i], nearest}, 0xBBBBBB, 0.8, false);
        canvas.text({0.5 * (name.left + name.right), name.bottom - 2.5}, points[i].name,
                    {nameSize, styleOf(points[i].family).color, Anchor::middle, true});
    }
    for (std::size_t i = points.size(); i-- > 0;) { // draws the front last, on top
        const Style style = styleOf(points[i].family);
        canvas.mark(places[i], style.shape, radius, points[i].front ? style.color : 0xFFFFFF,
                    style.color, hoverOf(points[i]));
    }
}

} // namespace edgeshade::plot
