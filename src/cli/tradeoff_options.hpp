#pragma once

#include "src/cli/options.hpp"
#include "src/gl/span_timer.hpp"

namespace edgeshade::cli {

/// Options of `tradeoff`, as typed.
struct TradeoffOptions : SceneOptions {
    std::string report;
    std::string plot;
    int frames{};
    bool framesTyped = false;
    int views{};
    bool viewsTyped = false;
    double timeLimit{}; ///< seconds
    int largestMap{};
    bool lightMoves = false;
    std::optional<double> budgetMs;
    std::optional<double> maxWrongPercent;
    std::optional<gl::Timing> timing;
    std::vector<std::string> against;
};

} // namespace edgeshade::cli
