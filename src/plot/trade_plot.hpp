#pragma once

#include "src/plot/canvas.hpp"

#include <vector>

namespace edgeshade::plot {

/// A setting in the plot.
struct TradePoint {
    std::string name;
    std::size_t family = 0;    ///< of TradePlot::families
    double milliseconds = 0.0; ///< 0 or more
    double wrongPercent = 0.0; ///< 0..100
    std::size_t bytes = 0;     ///< on the GPU
    bool front = false;        ///< on the Pareto front
    std::string note;          ///< what else there is to say where the pointer rests on it
};

struct TradePlot {
    std::string title;
    std::string subtitle;
    std::string timeLabel; ///< of the axis
    /// What kinds of settings there are. The n-th has the n-th colour and mark, whoever is there.
    std::vector<std::string> families;
    std::vector<TradePoint> points;
};

inline constexpr int tradePlotWidth = 1120;
inline constexpr int tradePlotHeight = 640;

/// Draws time against wrong pixels, both axes logarithmic, families by colour and mark, the Pareto
/// front filled, joined and named. Of an SVG's other points the name and the figures are said where
/// the pointer rests on them. What is wrong nowhere stands below the axis' last power of ten, at 0.
void drawTradePlot(Canvas& canvas, const TradePlot& plot);

} // namespace edgeshade::plot
