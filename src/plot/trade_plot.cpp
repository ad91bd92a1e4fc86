#include "src/plot/trade_plot.hpp"

#include "src/plot/labels.hpp"
#include "src/plot/log_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade::plot {
namespace {

constexpr Rectangle frame{86.0, 94.0, tradePlotWidth - 28.0, tradePlotHeight - 66.0};
constexpr Color ink = 0x222222, grey = 0x666666, gridColor = 0xE4E4E4;
constexpr double nameSize = 12.0, radius = 5.0;

Color colorOf(TradePoint::Family family) {
    switch (family) {
    case TradePoint::Family::volumes:
        return 0x2471A3;
    case TradePoint::Family::map:
        return 0xC0392B;
    case TradePoint::Family::none:
        break;
    }
    return 0x777777;
}

/// The axes: x milliseconds, y percent, and where 0 percent is.
struct Axes {
    LogAxis x, y;
    double zero; ///< y in pixels
    bool hasZero;
};

Axes axesFor(const std::vector<TradePoint>& points) {
    double fastest = INFINITY, slowest = 0.0, fewest = INFINITY, most = 0.0;
    bool hasZero = false;
    for (const TradePoint& point : points) {
        fastest = std::min(fastest, point.milliseconds);
        slowest = std::max(slowest, point.milliseconds);
        most = std::max(most, point.wrongPercent);
        hasZero = hasZero || point.wrongPercent == 0.0;
        if (point.wrongPercent > 0.0) fewest = std::min(fewest, point.wrongPercent);
    }
    if (!std::isfinite(fewest)) fewest = most = 1.0; // nothing is wrong anywhere
    const double below = std::pow(10.0, std::floor(std::log10(fewest)));
    const double above = std::max(1.6 * most, 10.0 * below);
    const double bottom = hasZero ? frame.bottom - 40.0 : frame.bottom;
    return {LogAxis(fastest / 1.35, slowest * 1.6, frame.left, frame.right),
            LogAxis(below, above, bottom, frame.top), frame.bottom - 8.0, hasZero};
}

void drawGrid(Canvas& canvas, const Axes& axes, const std::string& timeLabel) {
    const TextStyle below{11.0, grey, Anchor::middle}, beside{11.0, grey, Anchor::end};
    for (const double tick : axes.x.ticks()) {
        const double x = axes.x.at(tick);
        canvas.line(std::array{Point{x, frame.top}, Point{x, frame.bottom}}, gridColor, 1.0, false);
        canvas.text({x, frame.bottom + 18.0}, tickLabel(tick), below);
    }
    for (const double tick : axes.y.ticks()) {
        const double y = axes.y.at(tick);
        canvas.line(std::array{Point{frame.left, y}, Point{frame.right, y}}, gridColor, 1.0, false);
        canvas.text({frame.left - 8.0, y + 4.0}, tickLabel(tick), beside);
    }
    if (axes.hasZero) {
        canvas.line(std::array{Point{frame.left, axes.zero}, Point{frame.right, axes.zero}},
                    gridColor, 1.0, true);
        canvas.text({frame.left - 8.0, axes.zero + 4.0}, "0", beside);
    }
    canvas.line(std::array{Point{frame.left, frame.top}, Point{frame.left, frame.bottom},
                           Point{frame.right, frame.bottom}},
                ink, 1.2, false);
    canvas.text({0.5 * (frame.left + frame.right), frame.bottom + 46.0}, timeLabel,
                {13.0, ink, Anchor::middle});
    canvas.text({24.0, 0.5 * (frame.top + frame.bottom)}, "wrong pixels, percent of visible ones",
                {13.0, ink, Anchor::middle, false, true});
}

void drawLegend(Canvas& canvas) {
    double x = frame.right - 470.0;
    const double y = frame.top - 14.0;
    const auto entry = [&](const std::string& text, Color fill, Color rim, double width) {
        canvas.disc({x, y - 4.0}, radius, fill, rim);
        canvas.text({x + 11.0, y}, text, {12.0, ink});
        x += width;
    };
    const auto solid = [&](TradePoint::Family family, const std::string& text, double width) {
        entry(text, colorOf(family), colorOf(family), width);
    };
    solid(TradePoint::Family::volumes, "volumes", 84.0);
    solid(TradePoint::Family::map, "maps", 66.0);
    solid(TradePoint::Family::none, "no shadows", 104.0);
    entry("filled: nothing beats it in both", 0xFFFFFF, grey, 0.0);
}

} // namespace

void drawTradePlot(Canvas& canvas, const TradePlot& plot) {
    const Axes axes = axesFor(plot.points);
    canvas.text({frame.left, 30.0}, plot.title, {17.0, ink, Anchor::start, true});
    canvas.text({frame.left, 50.0}, plot.subtitle, {12.0, grey});
    drawLegend(canvas);
    drawGrid(canvas, axes, plot.timeLabel);

    // The front first, so that its names get the best places.
    std::vector<TradePoint> points = plot.points;
    std::stable_sort(points.begin(), points.end(), [](const TradePoint& a, const TradePoint& b) {
        return std::pair(!a.front, a.milliseconds) < std::pair(!b.front, b.milliseconds);
    });
    std::vector<Point> places, front;
    for (const TradePoint& point : points) {
        const double y = point.wrongPercent > 0.0 ? axes.y.at(point.wrongPercent) : axes.zero;
        places.push_back({axes.x.at(point.milliseconds), y});
        if (point.front) front.push_back(places.back());
    }
    if (front.size() > 1) canvas.line(front, 0x999999, 1.5, true);

    LabelPlaces labels(frame, places, radius);
    labels.keepOff(front);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double letter = points[i].front ? 0.68 : 0.6; // bold is wider
        const double width = letter * nameSize * static_cast<double>(points[i].name.size());
        const Rectangle name = labels.place(places[i], width, 1.1 * nameSize);
        const Point nearest{std::clamp(places[i].x, name.left, name.right),
                            std::clamp(places[i].y, name.top, name.bottom)};
        if (std::hypot(nearest.x - places[i].x, nearest.y - places[i].y) > 3.5 * radius)
            canvas.line(std::array{places[i], nearest}, 0xBBBBBB, 0.8, false);
        const Color color = colorOf(points[i].family);
        canvas.text({0.5 * (name.left + name.right), name.bottom - 2.5}, points[i].name,
                    {nameSize, color, Anchor::middle, points[i].front});
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Color color = colorOf(points[i].family);
        canvas.disc(places[i], radius, points[i].front ? color : 0xFFFFFF, color);
    }
}

} // namespace edgeshade::plot
