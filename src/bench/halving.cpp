#include "src/bench/halving.hpp"

#include "src/bench/confidence.hpp"
#include "src/bench/statistics.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <numeric>

namespace edgeshade::bench {
namespace {

constexpr int firstFrames = 8, firstViews = 4; // least number in a first round
constexpr std::size_t leastAlike = 8;          // wrong pixels
// Least spreads of logarithms, see logRatioBounds().
constexpr double spreadOfTimes = 0.03, spreadOfErrors = 0.5;
constexpr double leastLonger = 0.05; // logarithm: settings that take less than 5 % longer are not
                                     // dropped
// Shares of the time at which rounds must end: the first frames, and the views.
constexpr double firstFramesEnd = 0.35, viewsEnd = 0.75;

std::size_t wrongIn(std::span<const ViewErrors> views) {
    std::size_t sum = 0;
    for (const ViewErrors& view : views)
        sum += view.wrong;
    return sum;
}

/// Counts plus one, so that they have logarithms.
std::vector<double> positiveCounts(std::span<const ViewErrors> views) {
    std::vector<double> counts;
    for (const ViewErrors& view : views)
        counts.push_back(1.0 + static_cast<double>(view.wrong));
    return counts;
}

bool certainlyMoreWrong(std::span<const ViewErrors> own, std::span<const ViewErrors> other) {
    if (logRatioBounds(positiveCounts(own), positiveCounts(other), spreadOfErrors).low <= 0.0)
        return false;
    const double margin = 1.0 + 4.0 / static_cast<double>(own.size());
    return static_cast<double>(wrongIn(own)) > margin * static_cast<double>(wrongIn(other));
}

/// Whether two settings seem to draw the same pictures: they have equally many wrong pixels in
/// every view, and enough of them to rule out chance.
bool drawAlike(std::span<const ViewErrors> own, std::span<const ViewErrors> other) {
    const auto alike = [](const ViewErrors& a, const ViewErrors& b) { return a.wrong == b.wrong; };
    return own.size() >= firstViews && wrongIn(own) >= leastAlike &&
           std::equal(own.begin(), own.end(), other.begin(), other.end(), alike);
}

/// The rounds of `count` frames; each covers the whole flight, in its order.
std::deque<std::vector<int>> frameRounds(int count) {
    int step = 1;
    while ((count + 2 * step - 1) / (2 * step) >= firstFrames)
        step *= 2;
    std::deque<std::vector<int>> rounds;
    for (int taken = 0; step >= 1; taken = step, step /= 2) {
        std::vector<int>& round = rounds.emplace_back();
        for (int i = 0; i < count; i += step)
            if (taken == 0 || i % taken != 0) round.push_back(i);
    }
    return rounds;
}

std::vector<std::vector<int>> viewRounds(int count) {
    std::vector<std::vector<int>> rounds;
    for (int done = 0; done < count;) {
        std::vector<int>& round = rounds.emplace_back();
        for (const int end = std::min(count, std::max(firstViews, 2 * done)); done < end; ++done)
            round.push_back(done);
    }
    return rounds;
}

/// A run of halve().
class Halving {
  public:
    Halving(std::size_t count, const Effort& effort, Measurer& measurer)
        : effort_(effort), measurer_(measurer), standings_(count),
          steps_(effort.frames + effort.views) {
        who_.resize(count);
        std::iota(who_.begin(), who_.end(), std::size_t{0});
    }

    std::vector<Standing> run() {
        Steps timing{"frame", effort_.keepsFrames, [this](int i) { addFrame(i); }};
        Steps judging{"view", effort_.keepsViews, [this](int i) { addView(i); }};
        std::deque<std::vector<int>> frames = frameRounds(effort_.frames);
        prepare(timing, [this] { measurer_.prepareFrames(who_); });
        addRound(timing, frames.front(), firstFramesEnd);
        if (frames.front().empty()) frames.pop_front();

        prepare(judging, [this] { measurer_.prepareViews(who_); });
        for (std::vector<int>& round : viewRounds(effort_.views)) {
            const bool whole = addRound(judging, round, viewsEnd);
            if (!frames.empty() || judging.done < effort_.views) drop();
            if (!whole) break;
        }

        if (frames.empty() || !(timing.kept || fits(timing.preparing + timing.each, 1.0)))
            return std::move(standings_);
        prepare(timing, [this] { measurer_.prepareFrames(who_); });
        while (addRound(timing, frames.front(), 1.0)) {
            frames.pop_front();
            if (frames.empty()) break; // all is measured, so dropping saves nothing
            drop();
        }
        return std::move(standings_);
    }

  private:
    /// A measurement in steps: frames or views.
    struct Steps {
        const char* name;
        bool kept; ///< done however long it takes
        std::function<void(int)> add;
        double each = 0.0;      ///< seconds that the last one took per setting
        double preparing = 0.0; ///< seconds of preparation per setting
        int done = 0;
    };

    /// Whether work of `secondsOfSetting` per setting ends before that share of the time.
    bool fits(double secondsOfSetting, double shareOfTime) {
        return measurer_.clock() + secondsOfSetting * static_cast<double>(who_.size()) <=
               shareOfTime * effort_.seconds;
    }

    void prepare(Steps& steps, const std::function<void()>& use) {
        say(std::string("preparing ") + steps.name + "s");
        const double before = measurer_.clock();
        use();
        steps.preparing = (measurer_.clock() - before) / static_cast<double>(who_.size());
    }

    /// Measures a round, and removes from it what is done. Returns whether the time sufficed for
    /// all.
    bool addRound(Steps& steps, std::vector<int>& round, double shareOfTime) {
        ++rounds_;
        for (const std::size_t i : who_)
            standings_[i].rounds = rounds_;
        std::size_t done = 0;
        for (; done < round.size(); ++done) {
            if (!steps.kept && steps.done > 0 && !fits(steps.each, shareOfTime)) break;
            say("round " + std::to_string(rounds_) + ", " + std::to_string(who_.size()) +
                " settings, " + steps.name + " " + std::to_string(++steps.done));
            const double before = measurer_.clock();
            steps.add(round[done]);
            steps.each = (measurer_.clock() - before) / static_cast<double>(who_.size());
            ++stepsDone_;
        }
        round.erase(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(done));
        return round.empty();
    }

    void addFrame(int index) {
        const std::vector<double> times = measurer_.frame(index, who_);
        for (std::size_t k = 0; k < who_.size(); ++k)
            standings_[who_[k]].evidence.frameMs.push_back(times[k]);
    }

    void addView(int index) {
        const std::vector<ViewErrors> errors = measurer_.view(index, who_);
        for (std::size_t k = 0; k < who_.size(); ++k)
            standings_[who_[k]].evidence.views.push_back(errors[k]);
    }

    void drop() {
        std::vector<std::size_t> left;
        for (const std::size_t i : who_) {
            standings_[i].dominator = dominatorOf(i);
            if (!standings_[i].dominator) left.push_back(i);
        }
        who_ = std::move(left);
    }

    std::optional<std::size_t> dominatorOf(std::size_t i) const {
        for (const std::size_t j : who_)
            if (j != i && isCertainlyDominated(standings_[i].evidence, standings_[j].evidence))
                return j;
        return std::nullopt;
    }

    void say(const std::string& doing) {
        measurer_.progress(static_cast<double>(stepsDone_) / steps_, doing);
    }

    Effort effort_;
    Measurer& measurer_;
    std::vector<Standing> standings_;
    std::vector<std::size_t> who_; ///< settings not dropped
    int rounds_ = 0;
    int stepsDone_ = 0;
    double steps_;
};

double percentOf(std::span<const ViewErrors> views, std::size_t ViewErrors::*part) {
    std::size_t count = 0, visible = 0;
    for (const ViewErrors& view : views) {
        count += view.*part;
        visible += view.visible;
    }
    return visible == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(visible);
}

/// Bounds the mean of wrong pixels, with every view's share weighted by its pixels.
double wrongBelow(std::span<const ViewErrors> views) {
    const double visible = [&] {
        double sum = 0.0;
        for (const ViewErrors& view : views)
            sum += static_cast<double>(view.visible);
        return sum / std::max(1.0, static_cast<double>(views.size()));
    }();
    if (visible == 0.0) return 0.0;
    std::vector<double> percents;
    for (const ViewErrors& view : views)
        percents.push_back(100.0 * static_cast<double>(view.wrong) / visible);
    return meanBelow(percents);
}

Estimate estimateOf(const Evidence& evidence) {
    return {median(evidence.frameMs), percentOf(evidence.views, &ViewErrors::wrong),
            percentOf(evidence.views, &ViewErrors::beyond1px), medianBelow(evidence.frameMs),
            wrongBelow(evidence.views)};
}

/// Estimate of a dropped setting, from the one that dominated it.
Estimate estimateOf(const Evidence& own, const Evidence& dominator, const Estimate& of) {
    Estimate estimate = estimateOf(own);
    const double ratio =
        ratiosOf(own.frameMs, std::span(dominator.frameMs).first(own.frameMs.size())).median;
    const auto seen = std::span(dominator.views).first(own.views.size());
    estimate.milliseconds = of.milliseconds * ratio;
    estimate.wrongPercent += of.wrongPercent - percentOf(seen, &ViewErrors::wrong);
    estimate.beyond1pxPercent = std::max(0.0, estimate.beyond1pxPercent + of.beyond1pxPercent -
                                                  percentOf(seen, &ViewErrors::beyond1px));
    return estimate;
}

} // namespace

bool isCertainlyDominated(const Evidence& own, const Evidence& other) {
    return logRatioBounds(own.frameMs, other.frameMs, spreadOfTimes).low > leastLonger &&
           (certainlyMoreWrong(own.views, other.views) || drawAlike(own.views, other.views));
}

std::vector<Standing> halve(std::size_t count, const Effort& effort, Measurer& measurer) {
    return count == 0 ? std::vector<Standing>() : Halving(count, effort, measurer).run();
}

std::vector<Estimate> estimatesOf(std::span<const Standing> standings) {
    std::vector<std::optional<Estimate>> known(standings.size());
    // Ends, as every dominator is faster.
    const std::function<Estimate(std::size_t)> of = [&](std::size_t i) {
        const Standing& own = standings[i];
        if (!known[i])
            known[i] = own.dominator ? estimateOf(own.evidence, standings[*own.dominator].evidence,
                                                  of(*own.dominator))
                                     : estimateOf(own.evidence);
        return *known[i];
    };
    std::vector<Estimate> estimates;
    for (std::size_t i = 0; i < standings.size(); ++i)
        estimates.push_back(of(i));
    return estimates;
}

} // namespace edgeshade::bench
