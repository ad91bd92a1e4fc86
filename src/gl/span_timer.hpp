#pragma once

#include "src/gl/capabilities.hpp"

#include <deque>
#include <vector>

namespace edgeshade::gl {

/// How GL work is timed.
enum class Timing {
    query,     ///< by the GPU's clock, GL_EXT_disjoint_timer_query
    finish,    ///< by the wall clock, waiting (glFinish) before and after
    processor, ///< waits too, but measures this process's CPU time on all cores: the work of a
               ///< software GL, whatever else the machine does; says nothing about a GPU
};

/// Queries if the context has them and they cover all work, otherwise waiting. Timer queries of
/// Mesa's software renderers omit the vertex work, which is done before commands reach the queries.
Timing bestTiming(const Capabilities& capabilities);

/// Times spans of GL commands, one at a time. It doesn't wait for queries: a span is available some
/// frames later, in a browser after returning to the event loop.
///
///     timer.begin(label); ...; timer.end();
///     for (const SpanTimer::Span& span : timer.take()) ...
class SpanTimer {
  public:
    struct Span {
        int label = 0;
        double milliseconds = 0.0;
        bool disturbed = false; ///< the time is meaningless
    };

    /// Throws Error(unavailable) if `timing` needs queries and there are none.
    SpanTimer(Timing timing, const Capabilities& capabilities);
    ~SpanTimer();
    SpanTimer(const SpanTimer&) = delete;
    SpanTimer& operator=(const SpanTimer&) = delete;

    Timing timing() const { return timing_; }

    void begin(int label);
    void end();

    /// Returns each complete span once, in order.
    std::vector<Span> take() { return take(false); }
    /// Waits for all spans that have ended. Not in browsers.
    std::vector<Span> takeAll() { return take(true); }

  private:
    struct Pending {
        int label;
        Name query;
        bool disturbed = false;
    };
    std::vector<Span> take(bool wait);

    Timing timing_;
    std::optional<TimerQueries> queries_;
    std::vector<Name> free_;      ///< queries ready for reuse
    std::deque<Pending> pending_; ///< in order
    std::vector<Span> complete_;  ///< when timing by waiting
    int label_ = 0;               ///< of the running span
    double now() const;
    double start_ = 0.0; ///< milliseconds
};

} // namespace edgeshade::gl
