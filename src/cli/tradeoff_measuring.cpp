#include "src/cli/tradeoff_measuring.hpp"

#include "src/bench/pareto.hpp"
#include "src/cli/bench_report.hpp"
#include "src/cli/contender.hpp"
#include "src/cli/report.hpp"
#include "src/lab/error_survey.hpp"

#include <algorithm>
#include <sstream>

namespace edgeshade::cli {
namespace {

constexpr double tuningEnd = 0.4; // share of the time at which tuning of biases ends

/// Times frames and counts errors, one context at a time: each holds gigabytes of maps.
class RowMeasurer : public bench::Measurer {
  public:
    RowMeasurer(const TradeoffOptions& options, const LoadedScene& loaded,
                std::chrono::steady_clock::time_point began, std::vector<TradeRow>& rows)
        : options_(options), began_(began), loaded_(loaded), rows_(rows) {
        timed_.width = options.view.width;
        timed_.height = options.view.height;
        timed_.limits = options.glLimits;
        timed_.frames = options.frames;
        timed_.warmUp = 1;
        timed_.frustumAt = flightFor(options.view, loaded.scene);
        timed_.lights = requestFor(options.view, loaded.scene).lights;
        timed_.lightMoves = options.lightMoves;
        timed_.near = options.view.depth.near;
        timed_.timing = options.timing;
        judged_.limits = options.glLimits;
        lookAt(judged_, options.view, loaded.scene, options.views, options.viewsTyped);
        for (const TradeRow& row : rows)
            judged_.contenders.push_back(contenderOf(row.setting.name, row.settings, row.scene));
    }

    std::size_t viewCount() const { return judged_.views.size(); }
    const bench::Report& firstReport() const { return report_; }

    double clock() override {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }

    void prepareFrames(std::span<const std::size_t> who) override {
        survey_.reset();
        racing_.assign(who.begin(), who.end());
        timed_.settings.clear();
        for (const std::size_t i : who)
            timed_.settings.push_back(
                toTask({rows_[i].setting.name, rows_[i].settings, rows_[i].scene}));
        turns_ = std::make_unique<bench::Turns>(loaded_, timed_);
    }

    std::vector<double> frame(int index, std::span<const std::size_t> who) override {
        std::vector<std::size_t> places;
        for (const std::size_t i : who)
            places.push_back(
                static_cast<std::size_t>(std::ranges::lower_bound(racing_, i) - racing_.begin()));
        return turns_->frame(index, places);
    }

    void prepareViews(std::span<const std::size_t> who) override {
        report_ = turns_->report();
        for (std::size_t k = 0; k < racing_.size(); ++k)
            rows_[racing_[k]].bytes = report_.results[k].bytes();
        turns_.reset();
        survey_ = std::make_unique<lab::ErrorSurvey>(loaded_, judged_);
        survey_->prepare(who, [&] { return clock() < tuningEnd * options_.timeLimit; });
        for (const std::size_t i : who)
            if (const std::optional<float> bias = survey_->tunedBias(i)) takeBias(rows_[i], *bias);
    }

    std::vector<bench::ViewErrors> view(int index, std::span<const std::size_t> who) override {
        std::vector<bench::ViewErrors> errors;
        for (const lab::WrongCounts& counts : survey_->count(static_cast<std::size_t>(index), who))
            errors.push_back(
                {counts.wrongImagePixels, counts.wrongImageBeyond1px, counts.visiblePixels});
        return errors;
    }

    void progress(double share, const std::string& doing) override { bar_.show(share, doing); }

  private:
    static void takeBias(TradeRow& row, float bias) {
        row.settings.render.map.biasTexels = bias;
        std::ostringstream text;
        text << ",map-bias=" << bias;
        row.setting.text += text.str();
    }

    const TradeoffOptions& options_;
    std::chrono::steady_clock::time_point began_;
    ProgressBar bar_;
    const LoadedScene& loaded_;
    std::vector<TradeRow>& rows_;
    bench::Task timed_;
    lab::CompareTask judged_;
    std::vector<std::size_t> racing_; ///< the rows of timed_.settings
    std::unique_ptr<bench::Turns> turns_;
    std::unique_ptr<lab::ErrorSurvey> survey_;
    bench::Report report_; ///< of the first frames
};

} // namespace

TradeMeasuring measureRows(const TradeoffOptions& options, const LoadedScene& loaded,
                           std::chrono::steady_clock::time_point began,
                           std::vector<TradeRow>& rows) {
    RowMeasurer measurer(options, loaded, began, rows);
    const bench::Effort effort{options.frames, static_cast<int>(measurer.viewCount()),
                               options.framesTyped, options.viewsTyped, options.timeLimit};
    const std::vector<bench::Standing> standings = bench::halve(rows.size(), effort, measurer);
    measurer.progress(1.0, "done");
    const std::vector<bench::Estimate> estimates = bench::estimatesOf(standings);
    std::vector<bench::Trade> trades;
    TradeMeasuring measuring{measurer.firstReport().device, measurer.firstReport().timing, 0, 0,
                             measurer.clock()};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].standing = standings[i];
        rows[i].estimate = estimates[i];
        trades.push_back({estimates[i].milliseconds, estimates[i].wrongPercent});
        const bench::Evidence& evidence = standings[i].evidence;
        measuring.frames = std::max(measuring.frames, static_cast<int>(evidence.frameMs.size()));
        measuring.views = std::max(measuring.views, static_cast<int>(evidence.views.size()));
    }
    const std::vector<bool> front = bench::paretoFront(trades);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].pareto = front[i] && !rows[i].isDropped();
    return measuring;
}

} // namespace edgeshade::cli
