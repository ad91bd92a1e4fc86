#pragma once

#include "src/gl/capabilities.hpp"

#include <deque>
#include <vector>

namespace edgeshade::gl {

/// How the GL's work is timed.
enum class Timing {
    query,     ///< by the GPU's clock, GL_EXT_disjoint_timer_query
    finish,    ///< by the wall clock, waiting (glFinish) before and after
    processor, ///< waiting too, but by this process's time on all cores: the work of a software GL,
               ///< whatever else the machine does; says nothing about a GPU
};

/// Queries where the context has them and they tell all; else waiting. The timer queries of Mesa's
/// software renderers leave out the vertex work, which is done before commands reach the queries.
Timing bestTiming(const Capabilities& capabilities);

/// Times spans of GL commands, one at a time. Queries are not waited for: a span is there some
/// frames later, in a browser after returning to the event loop.
///
///     timer.begin(label); ...; timer.end();
///     for (const SpanTimer::Span& span : timer.take()) ...
class SpanTimer {
  public:
    struct Span {
        int label = 0;
        double milliseconds = 0.0;
        bool disturbed = false; ///< the time means nothing
    };

    /// Throws Error(unavailable) for queries where there are none.
    SpanTimer(Timing timing, const Capabilities& capabilities);
    ~SpanTimer();
    SpanTimer(const SpanTimer&) = delete;
    SpanTimer& operator=(const SpanTimer&) = delete;

    Timing timing() const { return timing_; }

    void begin(int label);
    void end();

    /// The spans that are complete, in their order, each once.
    std::vector<Span> take() { return take(false); }
    /// Waits for all that were ended. Not in browsers.
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
    std::vector<Name> free_;      ///< queries that can be used again
    std::deque<Pending> pending_; ///< in their order
    std::vector<Span> complete_;  ///< of waiting
    int label_ = 0;               ///< of the span that runs
    double now() const;
    double start_ = 0.0; ///< milliseconds
};

} // namespace edgeshade::gl
