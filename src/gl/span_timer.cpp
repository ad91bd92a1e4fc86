#include "src/gl/span_timer.hpp"

#include "preprocess/base/error.hpp"

#include <chrono>
#include <ctime>
#include <GLES2/gl2.h>
#include <utility>

namespace edgeshade::gl {

Timing bestTiming(const Capabilities& capabilities) {
    const bool complete = capabilities.renderer.find("llvmpipe") == std::string::npos &&
                          capabilities.renderer.find("softpipe") == std::string::npos;
    return capabilities.timerQueries && complete ? Timing::query : Timing::finish;
}

SpanTimer::SpanTimer(Timing timing, const Capabilities& capabilities)
    : timing_(timing), queries_(capabilities.timerQueries) {
    if (timing == Timing::query && !queries_)
        throw Error(ExitStatus::unavailable,
                    "This GL has no timer queries (GL_EXT_disjoint_timer_query).");
    if (queries_) queries_->wasDisturbed(); // resets the flag: disturbances count from here on
}

SpanTimer::~SpanTimer() {
    for (const Name query : free_)
        queries_->destroy(query);
    for (const Pending& pending : pending_)
        queries_->destroy(pending.query);
}

double SpanTimer::now() const {
    if (timing_ == Timing::processor)
        return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(time).count();
}

void SpanTimer::begin(int label) {
    label_ = label;
    if (timing_ != Timing::query) {
        glFinish();
        start_ = now();
        return;
    }
    if (free_.empty()) free_.push_back(queries_->make());
    pending_.push_back({label, free_.back(), false});
    free_.pop_back();
    queries_->begin(pending_.back().query);
}

void SpanTimer::end() {
    if (timing_ == Timing::query) return queries_->end();
    glFinish();
    complete_.push_back({label_, now() - start_, false});
}

std::vector<SpanTimer::Span> SpanTimer::take(bool wait) {
    std::vector<Span> spans = std::exchange(complete_, {});
    while (!pending_.empty() && (wait || queries_->isReady(pending_.front().query))) {
        const Pending& first = pending_.front();
        const auto nanoseconds = static_cast<double>(queries_->nanoseconds(first.query));
        spans.push_back({first.label, 1e-6 * nanoseconds, first.disturbed});
        free_.push_back(first.query);
        pending_.pop_front();
    }
    if (timing_ == Timing::query && queries_->wasDisturbed()) {
        for (Span& span : spans)
            span.disturbed = true;
        for (Pending& pending : pending_)
            pending.disturbed = true;
    }
    return spans;
}

} // namespace edgeshade::gl
