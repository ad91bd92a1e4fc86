#include "preprocess/base/error.hpp"
#include "src/bench/pareto.hpp"
#include "src/cli/bench_report.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/tradeoff_options.hpp"
#include "src/cli/tradeoff_report.hpp"

#include <memory>
#include <sstream>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string limitsOf(const TradeoffOptions& options) {
    std::ostringstream text;
    if (options.budgetMs) text << *options.budgetMs << " ms";
    if (options.budgetMs && options.maxWrongPercent) text << " and ";
    if (options.maxWrongPercent) text << *options.maxWrongPercent << " % wrong pixels";
    return text.str();
}

/// Chooses a row by bounds that other frames and views are unlikely to exceed; null if no row is
/// within the limits, or there are no limits.
const TradeRow* rowToTake(const TradeoffOptions& options, const std::vector<TradeRow>& rows) {
    if (!options.budgetMs && !options.maxWrongPercent) return nullptr;
    std::vector<const TradeRow*> left;
    std::vector<bench::Trade> trades;
    for (const TradeRow& row : rows) {
        if (row.isDropped()) continue;
        left.push_back(&row);
        trades.push_back({row.estimate.millisecondsBelow, row.estimate.wrongPercentBelow});
    }
    const auto best = bench::bestWithin(trades, {options.budgetMs, options.maxWrongPercent});
    return best ? left[*best] : nullptr;
}

void tradeoff(const TradeoffOptions& options) {
    const auto began = std::chrono::steady_clock::now();
    requirePlottable(options.plot);
    options.view.lights.sun.requireUp();
    if (options.view.lights.extents.typed())
        throw Error(ExitStatus::usage,
                    "tradeoff measures hard shadows only; 'bench' and 'compare' measure "
                    "lights with an extent.");
    const LoadedScene loaded =
        options.load(Shading::full, ShadowMethod::automatic, !options.culls.value_or(false));
    std::vector<std::string> warnings = loaded.scene.warnings.sentences();
    std::vector<TradeRow> rows = possibleRows(options, loaded, warnings);
    printWarnings(warnings);

    const TradeMeasuring measuring = measureRows(options, loaded, began, rows);
    if (measuring.device.isSoftware()) {
        warnings.push_back(softwareWarning(measuring.device));
        printWarnings({warnings.back()});
    }
    const TradeRow* best = rowToTake(options, rows);
    std::string result = tableOf(rows);
    if (best) result += "\nwithin " + limitsOf(options) + ": " + best->options();
    printResult(result, options.report);
    writeTradePlot(options, rows, measuring);
    Json json = {{"device", deviceJson(measuring.device)},
                 {"size", {options.view.width, options.view.height}},
                 {"frames", measuring.frames},
                 {"views", measuring.views},
                 {"seconds", measuring.seconds},
                 {"time_limit", options.timeLimit},
                 {"timing", nameOf(measuring.timing)},
                 {"light", options.lightMoves ? "moves" : "rests"},
                 {"rows", Json::array()}};
    if (options.view.lights.sun.typed()) json["sun"] = options.view.lights.sun.json();
    for (const TradeRow& row : rows)
        json["rows"].push_back(rowJson(row, rows));
    const bool demanding = options.budgetMs || options.maxWrongPercent;
    if (demanding) json["take"] = best ? rowJson(*best, rows) : Json(nullptr);
    json["warnings"] = warnings;
    writeReport(json, options.report);
    if (demanding && !best)
        throw Error(ExitStatus::unavailable,
                    "No setting stays within " + limitsOf(options) + " here.");
}

} // namespace

void addTradeoffCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "tradeoff",
        "Weigh the time of each setting against its wrong pixels, and find the best one");
    const auto options = std::make_shared<TradeoffOptions>();
    addSceneFile(*verb, *options)->required();
    addText(*verb, "--plot", options->plot);
    addNumber(*verb, "--budget-ms", options->budgetMs);
    addNumber(*verb, "--max-wrong-percent", options->maxWrongPercent);
    CLI::Option* const frames = addNumber(*verb, "--frames", options->frames);
    CLI::Option* const views = addNumber(*verb, "--views", options->views);
    addNumber(*verb, "--time-limit", options->timeLimit);
    addNumber(*verb, "--largest-map", options->largestMap);
    addTexts(*verb, "--against", options->against);
    verb->add_flag("--light-moves", options->lightMoves);
    addWords(*verb, "--timing", options->timing, timings);
    addSceneOptions(*verb, *options);
    addText(*verb, "--report", options->report);
    verb->callback([options, frames, views] {
        options->framesTyped = frames->count() > 0;
        options->viewsTyped = views->count() > 0;
        tradeoff(*options);
    });
}

} // namespace edgeshade::cli
