#pragma once

#include "src/plot/canvas.hpp"

#include <vector>

namespace edgeshade::plot {

/// A setting in the plot.
struct TradePoint {
    enum class Family { volumes, map, none };

    std::string name;
    Family family = Family::volumes;
    double milliseconds = 0.0; ///< above 0
    double wrongPercent = 0.0; ///< 0..100
    bool front = false;        ///< on the Pareto front
};

struct TradePlot {
    std::string title;
    std::string subtitle;
    std::string timeLabel; ///< of the axis
    std::vector<TradePoint> points;
};

inline constexpr int tradePlotWidth = 1000;
inline constexpr int tradePlotHeight = 640;

/// Draws time against wrong pixels, both axes logarithmic, every point named and the Pareto front
/// joined. What is wrong nowhere stands below the axis' last power of ten, at 0.
void drawTradePlot(Canvas& canvas, const TradePlot& plot);

} // namespace edgeshade::plot
