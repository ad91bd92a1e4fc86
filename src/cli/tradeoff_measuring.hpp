#pragma once

#include "src/cli/tradeoff_rows.hpp"

#include <chrono>

namespace edgeshade::cli {

/// How the rows were measured.
struct TradeMeasuring {
    gl::Capabilities device;
    gl::Timing timing = gl::Timing::finish;
    int frames = 0;       ///< of the rows that were not dropped
    int views = 0;        ///< likewise
    double seconds = 0.0; ///< all of it
};

/// Measures the rows by bench::halve(), within the time limit, but for frames and views that were
/// typed, from when the call began. Throws Error.
TradeMeasuring measureRows(const TradeoffOptions& options, const LoadedScene& loaded,
                           std::chrono::steady_clock::time_point began,
                           std::vector<TradeRow>& rows);

} // namespace edgeshade::cli
