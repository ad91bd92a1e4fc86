#pragma once

#include "src/plot/canvas.hpp"

#include <vector>

namespace edgeshade::plot {

/// A setting shown in the plot.
struct TradePoint {
    std::string name;
    std::size_t family = 0;    ///< index in TradePlot::families
    double milliseconds = 0.0; ///< 0 or more
    double wrongPercent = 0.0; ///< 0..100
    std::size_t bytes = 0;     ///< on the GPU
    bool front = false;        ///< on the Pareto front
    std::string note;          ///< more text to show when the pointer rests on it
};

struct TradePlot {
    std::string title;
    std::string subtitle;
    std::string timeLabel; ///< label of the time axis
    /// Kinds of settings. The n-th always has the n-th colour and mark, whichever are present.
    std::vector<std::string> families;
    std::vector<TradePoint> points;
};

inline constexpr int tradePlotWidth = 1120;
inline constexpr int tradePlotHeight = 640;

/// Draws time against wrong pixels, both axes logarithmic. Families differ by colour and mark; the
/// Pareto front is filled, joined and labelled. In an SVG the other points show name and figures
/// when the pointer rests on them. Settings without a wrong pixel are drawn below the axis' last
/// power of ten, at 0.
void drawTradePlot(Canvas& canvas, const TradePlot& plot);

} // namespace edgeshade::plot
