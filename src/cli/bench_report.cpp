#include "src/cli/bench_report.hpp"

#include "src/bench/flythrough.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/cli/report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int fewFrames = 10;
constexpr double unsteady = 1.25; // a factor of time

std::string sizeName(const bench::Task& task) {
    return std::to_string(task.width) + "x" + std::to_string(task.height);
}

/// Three significant digits, and no more decimals than milliseconds need.
std::string milliseconds(double value) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(value < 1.0 ? 3 : value < 10.0 ? 2 : 1) << value;
    return text.str();
}

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

/// Null if unknown.
Json fillJson(const std::optional<FillCost>& fill) {
    if (!fill) return nullptr;
    return {{"triangles", std::llround(fill->triangles)},
            {"tile_pairs", std::llround(fill->tilePairs)},
            {"blocks", std::llround(fill->blocks)},
            {"fragments", std::llround(fill->fragments)},
            {"llvmpipe_ms", 1e-6 * FillWeights().of(*fill)}};
}

Json resultJson(const bench::Task& task, const BenchSetting& setting, const bench::Result& result,
                const bench::Report& measured, const CasterSettings& casters, const Json& scene) {
    DrawSettings settings = setting.settings;
    settings.render = result.settings;
    Json settingsOf = settingsJson(settings);
    settingsOf.update(casterJson(setting.scene ? setting.scene->settings : casters));
    settingsOf["samples"] = measured.device.samples;
    settingsOf.update(scene);
    const bench::Spread spread = bench::spreadOf(result.frameMs);
    const StageMs& stages = result.stageMs;
    return {{"name", result.name},
            {"device", deviceJson(measured.device)},
            {"size", {task.width, task.height}},
            {"frames", task.frames},
            {"timing", nameOf(measured.timing)},
            {"light", task.lightMoves ? "moves" : "rests"},
            {"lights", task.scattered ? Json::array() : methodsJson(result.lights)},
            {"light_count", task.lights.size()},
            {"lights_reaching", result.lightsReaching},
            {"lights_shadowed", result.lightsShadowed},
            {"settings", settingsOf},
            {"frame_ms", {{"median", spread.median}, {"p95", spread.p95}, {"max", spread.max}}},
            {"stage_ms",
             {{"ambient", stages.ambient},
              {"silhouette", stages.silhouette},
              {"rasterise", stages.rasterise},
              {"map", stages.map},
              {"lit", stages.lit}}},
            {"plan_ms", result.planMs},
            {"vertex_runs", result.vertexRuns},
            {"fill", fillJson(result.fill)},
            {"bytes_gpu", result.bytes()},
            {"bytes",
             {{"sides", result.sideBytes},
              {"caps", result.capBytes},
              {"maps", result.mapBytes},
              {"masks", result.maskBytes},
              {"light_table", result.tableBytes}}},
            {"repeated", result.repeated}};
}

} // namespace

const std::string& nameOf(gl::Timing timing) {
    return optionOf("", "--timing").values.words.at(static_cast<std::size_t>(timing));
}

std::string softwareWarning(const gl::Capabilities& device) {
    return "This GL draws on the processor (" + device.renderer +
           "); ratios on a GPU can be quite different.";
}

bench::Setting toTask(const BenchSetting& setting) {
    bench::Setting task{
        setting.name, setting.settings.render, {}, setting.settings.depthSlices, setting.scene};
    if (setting.settings.instancing != InstancingChoice::automatic)
        task.layout = layoutFor(setting.settings.instancing, {});
    return task;
}

std::function<Frustum(double)> flightFor(const ViewOptions& view, const Scene& scene) {
    if (view.hasCamera())
        return [frustum = requestFor(view, scene).frustum](double) { return frustum; };
    const double aspect = view.aspect();
    const bench::Flythrough flight(worldBounds(scene), view.fovDegrees, aspect);
    return [flight, aspect, height = view.orthoHeight](double share) {
        return frustumOf(flight.cameraAt(share), aspect, height);
    };
}

void Countdown::show(double share, const std::string& doing) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    std::string text = doing;
    if (share > 0.0 && share < 1.0) {
        const double left = passed.count() * (1.0 - share) / share;
        text += left < 90.0 ? ", " + fixed(std::ceil(left), 0) + " s left"
                            : ", " + fixed(std::ceil(left / 60.0), 0) + " min left";
    }
    bar_.show(share, text, doing.substr(0, doing.find(", multiplicity")));
}

void BenchReport::add(const bench::Task& task, const std::vector<BenchSetting>& settings,
                      const bench::Report& measured) {
    if (rows_.empty()) {
        heading_ = std::to_string(task.frames) + " frames, " +
                   (task.lightMoves ? "lights move" : "lights rest") + ", timed by " +
                   nameOf(measured.timing) + ", " + measured.device.renderer;
        if (measured.device.isSoftware()) doubts_.push_back(softwareWarning(measured.device));
        if (task.frames < fewFrames)
            doubts_.push_back("Medians of " + std::to_string(task.frames) +
                              (task.frames == 1 ? " frame" : " frames") + " are unreliable.");
    }
    const bench::Result& own = measured.results.front();
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const bench::Result& result = measured.results[i];
        const bench::Ratios ratios = bench::ratiosOf(own.frameMs, result.frameMs);
        rows_.push_back(
            {sizeName(task), task.scattered ? task.lights.size() : 0, result, ratios, i == 0});
        results_.push_back(resultJson(task, settings[i], result, measured, casters, scene));
        if (i > 0)
            ratios_.push_back({{"name", result.name},
                               {"size", {task.width, task.height}},
                               {"light_count", task.lights.size()},
                               {"median", ratios.median},
                               {"min", ratios.min},
                               {"max", ratios.max}});
        if (result.repeated > unsteady || result.repeated < 1.0 / unsteady)
            doubts_.push_back(
                sizeName(task) + ", " + result.name +
                (task.scattered ? ", " + std::to_string(task.lights.size()) + " lights" : "") +
                ": the first frames took " + fixed(result.repeated, 2) +
                " times as long when drawn again at the end; something else keeps "
                "this machine busy, or its clock changes.");
    }
}

std::string BenchReport::table() const {
    std::size_t longest = 8;
    for (const Row& row : rows_)
        longest = std::max(longest, row.result.name.size());
    const auto name = static_cast<int>(longest + 2);
    std::ostringstream text;
    text << heading_ << "\n"
         << std::left << std::setw(11) << "size" << std::setw(name) << "setting" << std::right;
    const bool scattered = rows_.front().lights > 0;
    if (scattered)
        text << std::setw(8) << "lights" << std::setw(10) << "reaching" << std::setw(10)
             << "shadowed";
    for (const char* head :
         {"median ms", "p95", "max", "ambient", "silhouette", "rasterise", "map", "lit"})
        text << std::setw(11) << head;
    text << std::setw(14) << "vertex runs" << std::setw(12) << "tile pairs" << std::setw(12)
         << "Mfragments" << std::setw(10) << "MB on GPU"
         << "  first setting's time / this: median (min..max)";
    for (const Row& row : rows_) {
        const bench::Result& result = row.result;
        const bench::Spread spread = bench::spreadOf(result.frameMs);
        const StageMs& stages = result.stageMs;
        text << "\n"
             << std::left << std::setw(11) << row.size << std::setw(name) << result.name
             << std::right;
        if (scattered)
            text << std::setw(8) << row.lights << std::setw(10) << result.lightsReaching
                 << std::setw(10) << result.lightsShadowed;
        for (const double value : {spread.median, spread.p95, spread.max, stages.ambient,
                                   stages.silhouette, stages.rasterise, stages.map, stages.lit})
            text << std::setw(11) << milliseconds(value);
        text << std::setw(14) << result.vertexRuns << std::setw(12)
             << (result.fill ? fixed(result.fill->tilePairs, 0) : "-") << std::setw(12)
             << (result.fill ? fixed(1e-6 * result.fill->fragments, 2) : "-") << std::setw(10)
             << fixed(static_cast<double>(result.bytes()) / (1 << 20), 2);
        if (!row.first)
            text << "  " << fixed(row.ratios.median, 3) << " (" << fixed(row.ratios.min, 3) << ".."
                 << fixed(row.ratios.max, 3) << ")";
    }
    const bool restingMap = std::any_of(rows_.begin(), rows_.end(), [](const Row& row) {
        return row.result.mapBytes > 0 && row.result.vertexRuns == 0;
    });
    if (restingMap)
        text << "\nShadow maps were drawn once and kept; --light-moves draws them for every frame.";
    return text.str();
}

Json BenchReport::json() const {
    Json all = warnings;
    for (const std::string& doubt : doubts_)
        all.push_back(doubt);
    if (results_.size() == 1) {
        Json single = results_.front();
        single["warnings"] = all;
        return single;
    }
    return {{"results", results_}, {"ratios", ratios_}, {"warnings", all}};
}

} // namespace edgeshade::cli
