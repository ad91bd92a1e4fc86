#pragma once

#include "src/cli/tradeoff_rows.hpp"

#include <chrono>

namespace edgeshade::cli {

/// How the rows were measured.
struct TradeMeasuring {
    gl::Capabilities device;
    gl::Timing timing = gl::Timing::finish;
    int frames = 0;       ///< for the rows that were not dropped
    int views = 0;        ///< for the rows that were not dropped
    double seconds = 0.0; ///< in total
};

/// Measures the rows by bench::halve() within the time limit, which runs from `began`. Frames and
/// views that were typed are exempt from the limit. Throws Error.
TradeMeasuring measureRows(const TradeoffOptions& options, const LoadedScene& loaded,
                           std::chrono::steady_clock::time_point began,
                           std::vector<TradeRow>& rows);

} // namespace edgeshade::cli
