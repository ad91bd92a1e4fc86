#include "preprocess/base/error.hpp"
#include "src/cli/bench_report.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"

#include <memory>

#ifdef EDGESHADE_HAS_LAB
#include "src/bench/bench.hpp"
#include "src/bench/pareto.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/cli/contender.hpp"
#include "src/cli/report.hpp"
#include "src/cli/tradeoff_settings.hpp"
#include "src/gl/headless_context.hpp"
#include "src/lab/compare.hpp"
#include "src/plot/trade_plot.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>
#endif

namespace edgeshade::cli {
namespace {

struct TradeoffOptions : SceneOptions {
    std::string report;
    std::string plot;
    int frames = 40;
    int views = 16;
    bool viewsTyped = false;
    int largestMap = 8192;
    bool lightMoves = false;
    std::optional<double> budgetMs;
    std::optional<double> maxWrongPercent;
    std::optional<gl::Timing> timing;
    std::vector<std::string> against;
};

#ifdef EDGESHADE_HAS_LAB

using Json = nlohmann::ordered_json;

/// A setting with what it costs and what it gets wrong.
struct Row {
    TradeSetting setting; ///< with the bias that was tuned
    DrawSettings settings;
    std::shared_ptr<const LoadedScene> scene; ///< with their casters; null: the call's own
    CasterSettings casters;
    std::string callsOptions; ///< of the call's casters, as far as the setting leaves them
    bench::Result cost;
    lab::CompareResult accuracy;
    bool pareto = false;

    std::string options() const { return asOptions(setting.text) + callsOptions; }
    double milliseconds() const { return bench::median(cost.frameMs); }
    double wrongPercent() const {
        return lab::percent(accuracy.counts.wrongImagePixels, accuracy.counts.visiblePixels);
    }
    double beyond1pxPercent() const {
        return lab::percent(accuracy.counts.wrongImageBeyond1px, accuracy.counts.visiblePixels);
    }
};

std::string plotEnding(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(dot);
}

void requirePlottable(const std::string& path) {
    if (path.empty()) return;
    const std::string ending = plotEnding(path);
    if (ending == ".png") plot::pngCanvas(1, 1); // says so now where it can't
    if (ending != ".png" && ending != ".svg")
        throw Error(ExitStatus::usage, "--plot: '" + path + "' ends neither in .svg nor in .png.");
}

/// The settings that this GL can draw; what it can't is left out with a warning.
std::vector<Row> possibleRows(const TradeoffOptions& options, const LoadedScene& loaded,
                              std::vector<std::string>& warnings) {
    std::vector<TradeSetting> all =
        tradeSettings(options.largestMap, worldBounds(loaded.scene).diagonal(),
                      requestFor(options.view, loaded.scene).lights);
    for (const std::string& text : options.against)
        all.push_back({text, text});
    CasterVariants variants(options.input, loaded);
    const std::string sceneOptions =
        (options.cutoutsCast ? std::string(" --cast-cutouts") : std::string()) +
        (options.ground ? " --ground '" + textOf(*options.ground) + "'" : "") +
        (options.culls ? std::string(" --cull ") + (*options.culls ? "auto" : "off") : "") +
        (options.time ? " --time " + Json(*options.time).dump() : "") +
        (options.animation.empty() ? "" : " --animation " + Json(options.animation).dump());
    const gl::HeadlessContext context({16, 16, 0, options.glLimits});
    std::vector<Row> rows;
    for (const TradeSetting& setting : all) {
        Row row;
        row.setting = setting;
        row.settings = settingsFrom(DrawSettings(), setting.text);
        if (loaded.scene.culls && drawOppositeVertices(std::array{row.settings})) {
            warnings.push_back(setting.name + " is left out: --cull auto does not go with it.");
            continue;
        }
        RenderSettings render = row.settings.render;
        render.layout = layoutFor(row.settings.instancing, context.capabilities());
        try {
            Renderer(render, context.capabilities());
            row.scene = variants.with(row.settings.casters);
            row.casters = variants.settingsWith(row.settings.casters);
            row.callsOptions = leftOptions(options.casters, row.settings.casters) + sceneOptions;
            rows.push_back(std::move(row));
        } catch (const Error& error) {
            if (error.status() != ExitStatus::unavailable) throw;
            warnings.push_back(setting.name + " is left out: " + error.what());
        }
    }
    return rows;
}

bench::Report measureCosts(const TradeoffOptions& options, const LoadedScene& loaded,
                           std::vector<Row>& rows) {
    bench::Task task;
    task.width = options.view.width;
    task.height = options.view.height;
    task.limits = options.glLimits;
    task.frames = options.frames;
    task.frustumAt = flightFor(options.view, loaded.scene);
    task.lights = requestFor(options.view, loaded.scene).lights;
    task.lightMoves = options.lightMoves;
    task.near = options.view.depth.near;
    task.timing = options.timing;
    for (const Row& row : rows)
        task.settings.push_back(toTask({row.setting.name, row.settings, row.scene}));
    Countdown countdown;
    bench::Report report =
        bench::measure(loaded, task, [&](double share) { countdown.show(share, "times"); });
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].cost = report.results[i];
    return report;
}

void measureErrors(const LoadedScene& loaded, lab::CompareTask task, std::vector<Row>& rows) {
    for (const Row& row : rows)
        task.contenders.push_back(contenderOf(row.setting.name, row.settings, row.scene));
    Countdown countdown;
    const auto results = lab::compareAll(loaded, task, [&](double share, const std::string& doing) {
        countdown.show(share, doing);
    });
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        row.accuracy = results[i];
        if (!task.contenders[i].tuneMapBias) continue;
        row.settings.render.map.biasTexels = results[i].settings.map.biasTexels;
        std::ostringstream bias;
        bias << ",map-bias=" << results[i].settings.map.biasTexels;
        row.setting.text += bias.str();
    }
}

std::vector<bench::Trade> tradesOf(const std::vector<Row>& rows) {
    std::vector<bench::Trade> trades;
    for (const Row& row : rows)
        trades.push_back({row.milliseconds(), row.wrongPercent()});
    return trades;
}

std::string tableOf(const std::vector<Row>& rows) {
    std::ostringstream text;
    text << std::left << std::setw(28) << "setting" << std::right << std::setw(11) << "median ms"
         << std::setw(10) << "p95" << std::setw(11) << "MB on GPU" << std::setw(15)
         << "image wrong %" << std::setw(13) << "beyond 1px"
         << "  front  options";
    for (const Row& row : rows)
        text << "\n"
             << std::left << std::setw(28) << row.setting.name << std::right << std::fixed
             << std::setprecision(2) << std::setw(11) << row.milliseconds() << std::setw(10)
             << bench::percentile(row.cost.frameMs, 0.95) << std::setw(11)
             << static_cast<double>(row.cost.bytes()) / (1 << 20) << std::setprecision(5)
             << std::setw(15) << row.wrongPercent() << std::setw(13) << row.beyond1pxPercent()
             << (row.pareto ? "    *    " : "         ") << row.options();
    return text.str();
}

Json rowJson(const Row& row) {
    Json settings = settingsJson(row.settings);
    settings.update(casterJson(row.casters));
    return {{"name", row.setting.name},
            {"settings", settings},
            {"options", row.options()},
            {"frame_ms", row.milliseconds()},
            {"bytes_gpu", row.cost.bytes()},
            {"wrong_image_percent", row.wrongPercent()},
            {"wrong_image_beyond_1px_percent", row.beyond1pxPercent()},
            {"pareto", row.pareto}};
}

plot::TradePoint pointOf(const Row& row) {
    using Family = plot::TradePoint::Family;
    const ShadowMethod shadows = row.settings.render.shadows;
    const Family family = shadows == ShadowMethod::map    ? Family::map
                          : shadows == ShadowMethod::none ? Family::none
                                                          : Family::volumes;
    return {row.setting.name, family, row.milliseconds(), row.wrongPercent(), row.pareto};
}

void writePlot(const TradeoffOptions& options, const std::vector<Row>& rows,
               const bench::Report& measured) {
    if (options.plot.empty()) return;
    plot::TradePlot trade;
    trade.title = "What shadows cost, and what is wrong with them: " +
                  std::filesystem::path(options.input).filename().string();
    trade.subtitle = std::to_string(options.view.width) + "x" +
                     std::to_string(options.view.height) + ", median of " +
                     std::to_string(options.frames) + " frames, " +
                     (options.lightMoves ? "light moving" : "light at rest, maps kept") + ", " +
                     std::to_string(rows.front().accuracy.views) + " views against the oracle; " +
                     measured.device.renderer;
    trade.timeLabel = measured.timing == gl::Timing::processor ? "processor time of a frame, ms"
                                                               : "time of a frame, ms";
    for (const Row& row : rows)
        trade.points.push_back(pointOf(row));
    const auto canvas = plotEnding(options.plot) == ".png"
                            ? plot::pngCanvas(plot::tradePlotWidth, plot::tradePlotHeight)
                            : plot::svgCanvas(plot::tradePlotWidth, plot::tradePlotHeight);
    plot::drawTradePlot(*canvas, trade);
    writeFile(options.plot, canvas->file());
}

std::string limitsOf(const TradeoffOptions& options) {
    std::ostringstream text;
    if (options.budgetMs) text << *options.budgetMs << " ms";
    if (options.budgetMs && options.maxWrongPercent) text << " and ";
    if (options.maxWrongPercent) text << *options.maxWrongPercent << " % wrong pixels";
    return text.str();
}

void tradeoff(const TradeoffOptions& options) {
    requirePlottable(options.plot);
    options.view.lights.sun.requireUp();
    if (options.view.lights.extents.typed())
        throw Error(ExitStatus::usage, "tradeoff is of hard shadows; 'bench' and 'compare' measure "
                                       "lights with an extent.");
    const LoadedScene loaded =
        options.load(Shading::full, ShadowMethod::automatic, !options.culls.value_or(false));
    std::vector<std::string> warnings = loaded.scene.warnings.sentences();
    std::vector<Row> rows = possibleRows(options, loaded, warnings);
    const bool demanding = options.budgetMs || options.maxWrongPercent;
    printWarnings(warnings);

    lab::CompareTask compared;
    compared.limits = options.glLimits;
    lookAt(compared, options.view, loaded.scene, options.views, options.viewsTyped);
    const bench::Report measured = measureCosts(options, loaded, rows);
    if (measured.device.isSoftware()) {
        warnings.push_back(softwareWarning(measured.device));
        printWarnings({warnings.back()});
    }
    measureErrors(loaded, compared, rows);
    const std::vector<bench::Trade> trades = tradesOf(rows);
    const std::vector<bool> front = bench::paretoFront(trades);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].pareto = front[i];

    const Row* best = nullptr;
    if (const auto found = bench::bestWithin(trades, {options.budgetMs, options.maxWrongPercent}))
        best = demanding ? &rows[*found] : nullptr;
    std::string result = tableOf(rows);
    if (best) result += "\nwithin " + limitsOf(options) + ": " + best->options();
    printResult(result, options.report);
    writePlot(options, rows, measured);
    Json json = {{"device", deviceJson(measured.device)},
                 {"size", {options.view.width, options.view.height}},
                 {"frames", options.frames},
                 {"views", rows.front().accuracy.views},
                 {"timing", nameOf(measured.timing)},
                 {"light", options.lightMoves ? "moves" : "rests"},
                 {"rows", Json::array()}};
    if (options.view.lights.sun.typed()) json["sun"] = options.view.lights.sun.json();
    for (const Row& row : rows)
        json["rows"].push_back(rowJson(row));
    if (demanding) json["take"] = best ? rowJson(*best) : Json(nullptr);
    json["warnings"] = warnings;
    writeReport(json, options.report);
    if (demanding && !best)
        throw Error(ExitStatus::unavailable,
                    "No setting keeps within " + limitsOf(options) + " here.");
}

#else

void tradeoff(const TradeoffOptions&) {
    throw Error(ExitStatus::unavailable,
                "tradeoff needs the ray-traced oracle, and this program was built without Embree.");
}

#endif

} // namespace

void addTradeoffCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "tradeoff", "What every setting costs and what it gets wrong: a table, a plot, and the one "
                    "setting to take");
    const auto options = std::make_shared<TradeoffOptions>();
    verb->add_option("FILE", options->input, "The scene, .gltf or .glb, packed or not")->required();
    verb->add_option("--plot", options->plot,
                     "Draw time against wrong pixels, as .svg or .png by its ending")
        ->type_name("OUT");
    verb->add_option("--budget-ms", options->budgetMs,
                     "Say which setting has the fewest wrong pixels within this time of a frame")
        ->check(finite())
        ->check(CLI::PositiveNumber)
        ->type_name("MS");
    verb->add_option("--max-wrong-percent", options->maxWrongPercent,
                     "Say which setting is the fastest with no more wrong pixels than this, in "
                     "percent of visible ones")
        ->check(finite())
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("P");
    verb->add_option("--frames", options->frames, "Frames to time, 1 to 100000 (40)")
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
    CLI::Option* views =
        verb->add_option("--views", options->views,
                         "Views to count wrong pixels in, 1 to 1000 (16; with a camera of yours "
                         "that one alone), those of compare")
            ->check(CLI::Range(1, 1000))
            ->type_name("N");
    verb->add_option("--largest-map", options->largestMap,
                     "Leave larger shadow maps out (8192; its cube takes 1.9 GB)")
        ->check(CLI::Range(512, 8192))
        ->type_name("N");
    verb->add_option("--against", options->against,
                     "Another setting to weigh too, e.g. shadows=map,map-size=3000 or "
                     "caster-error=0.01; may be repeated")
        ->type_name("SETTING")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_flag("--light-moves", options->lightMoves,
                   "Lights draw small circles while times are taken, so shadow maps are drawn anew "
                   "for every frame; without, they are kept");
    addTimingOption(*verb, options->timing);
    addSceneOptions(*verb, *options);
    addReportOption(*verb, options->report);
    verb->callback([options, views] {
        options->viewsTyped = views->count() > 0;
        tradeoff(*options);
    });
}

} // namespace edgeshade::cli
