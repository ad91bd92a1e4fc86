#include "src/cli/tradeoff_report.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/cli/tradeoff_family.hpp"
#include "src/plot/trade_plot.hpp"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace edgeshade::cli {
namespace {

std::string endingOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(dot);
}

plot::TradePoint pointOf(const TradeRow& row, const std::vector<TradeRow>& rows,
                         const std::vector<std::string>& families) {
    const auto family = std::ranges::find(families, familyOf(row.settings));
    return {row.setting.name,
            static_cast<std::size_t>(family - families.begin()),
            row.estimate.milliseconds,
            row.estimate.wrongPercent,
            row.bytes,
            row.pareto,
            row.isDropped() ? "dominated early by " + rows[*row.standing.dominator].setting.name
                            : ""};
}

} // namespace

std::string tableOf(const std::vector<TradeRow>& rows) {
    std::ostringstream text;
    text << std::left << std::setw(28) << "setting" << std::right << std::setw(11) << "median ms"
         << std::setw(11) << "MB on GPU" << std::setw(15) << "image wrong %" << std::setw(13)
         << "beyond 1px" << std::setw(8) << "frames" << std::setw(7) << "views"
         << "  front  options";
    for (const TradeRow& row : rows)
        text << "\n"
             << std::left << std::setw(28) << row.setting.name << std::right << std::fixed
             << std::setprecision(2) << std::setw(11) << row.estimate.milliseconds << std::setw(11)
             << static_cast<double>(row.bytes) / (1 << 20) << std::setprecision(5) << std::setw(15)
             << row.estimate.wrongPercent << std::setw(13) << row.estimate.beyond1pxPercent
             << std::setw(8) << row.standing.evidence.frameMs.size() << std::setw(7)
             << row.standing.evidence.views.size() << (row.pareto ? "    *    " : "         ")
             << row.options();
    return text.str();
}

nlohmann::ordered_json rowJson(const TradeRow& row, const std::vector<TradeRow>& rows) {
    nlohmann::ordered_json settings = settingsJson(row.settings);
    settings.update(casterJson(row.casters));
    nlohmann::ordered_json json = {
        {"name", row.setting.name},
        {"settings", settings},
        {"options", row.options()},
        {"frame_ms", row.estimate.milliseconds},
        {"bytes_gpu", row.bytes},
        {"wrong_image_percent", row.estimate.wrongPercent},
        {"wrong_image_beyond_1px_percent", row.estimate.beyond1pxPercent},
        {"pareto", row.pareto},
        {"rounds", row.standing.rounds},
        {"frames", row.standing.evidence.frameMs.size()},
        {"views", row.standing.evidence.views.size()},
        {"dominated_early", row.isDropped()}};
    if (row.isDropped()) {
        json["dominated_by"] = rows[*row.standing.dominator].setting.name;
    } else {
        json["frame_ms_below"] = row.estimate.millisecondsBelow;
        json["wrong_image_percent_below"] = row.estimate.wrongPercentBelow;
    }
    return json;
}

void requirePlottable(const std::string& path) {
    if (path.empty()) return;
    const std::string ending = endingOf(path);
    if (ending == ".png") plot::pngCanvas(1, 1); // fail early if PNG can't be written
    if (ending != ".png" && ending != ".svg")
        throw Error(ExitStatus::usage, "--plot: '" + path + "' ends neither in .svg nor in .png.");
}

void writeTradePlot(const TradeoffOptions& options, const std::vector<TradeRow>& rows,
                    const TradeMeasuring& measuring) {
    if (options.plot.empty()) return;
    plot::TradePlot trade;
    trade.title = "Cost and errors of shadow settings: " +
                  std::filesystem::path(options.input).filename().string();
    trade.subtitle =
        std::to_string(options.view.width) + "x" + std::to_string(options.view.height) +
        ", median of " + std::to_string(measuring.frames) + " frames, " +
        (options.lightMoves ? "light moving" : "light at rest, maps kept") + ", " +
        std::to_string(measuring.views) + " views against the oracle; " + measuring.device.renderer;
    trade.timeLabel = measuring.timing == gl::Timing::processor ? "processor time of a frame, ms"
                                                                : "time of a frame, ms";
    for (const TradeRow& row : rows)
        trade.families.push_back(familyOf(row.settings));
    trade.families = allFamilies(trade.families);
    for (const TradeRow& row : rows)
        trade.points.push_back(pointOf(row, rows, trade.families));
    const auto canvas = endingOf(options.plot) == ".png"
                            ? plot::pngCanvas(plot::tradePlotWidth, plot::tradePlotHeight)
                            : plot::svgCanvas(plot::tradePlotWidth, plot::tradePlotHeight);
    plot::drawTradePlot(*canvas, trade);
    writeFile(options.plot, canvas->file());
}

} // namespace edgeshade::cli
