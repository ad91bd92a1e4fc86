#include "preprocess/base/error.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/contender.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/image/png.hpp"
#include "src/lab/compare.hpp"
#include "src/lab/compare_counts.hpp"
#include "src/scene/pose.hpp"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <set>
#include <sstream>

namespace edgeshade::cli {
namespace {

/// The stage of progress; all views are one stage.
std::string stageOf(const std::string& doing) {
    return doing.starts_with("view ") ? "comparing views" : doing;
}

struct CompareOptions : SceneOptions {
    std::string report;
    std::string heatmap;
    int views{};
    DrawSettings settings;
    std::vector<std::string> against;
};

using Json = nlohmann::ordered_json;

Json countsJson(const lab::WrongCounts& counts) {
    Json json;
    for (const auto& [key, count] : lab::WrongCounts::keys)
        json[key] = counts.*count;
    return json;
}

Json resultJson(const lab::CompareResult& result, DrawSettings settings,
                const CasterSettings& casters, const std::vector<lab::LabView>& views) {
    settings.render = result.settings;
    Json json = {{"name", result.name},
                 {"views", result.views},
                 {"subpixel_bits", result.subpixelBits}}; // of the grid that decides device ties
    json.update(countsJson(result.counts));
    json["worst_view"] = views.empty() ? Json(nullptr) : Json(views[result.worstView].name);
    json["lights"] = methodsJson(result.lights);
    json["settings"] = settingsJson(settings);
    json["settings"].update(casterJson(casters));
    Json byView = Json::array();
    for (std::size_t v = 0; v < result.byView.size(); ++v) {
        Json one = {{"name", views[v].name}};
        one.update(countsJson(result.byView[v]));
        byView.push_back(std::move(one));
    }
    json["by_view"] = std::move(byView);
    return json;
}

Json sumsJson(const lab::WrongSums& sums) {
    return {{"pixels", sums.pixels},
            {"visible_pixels", sums.visiblePixels},
            {"points", sums.points},
            {"wrong_points", sums.wrong},
            {"wrong_points_percent", sums.percent()},
            {"wrong_count_pixels", sums.wrongPixels},
            {"wrong_count_beyond_1px", sums.beyond1px},
            {"wrong_count_beyond_1px_not_tied", sums.beyond1pxNotTied},
            {"largest_wrong_count", sums.largest}};
}

/// Warns once for each light that got no primitive map although the user requested one by name.
template <typename Result>
void warnOfFallbacks(const std::vector<Result>& results) {
    std::set<std::string> warned;
    for (const Result& result : results)
        printNewWarnings(fallbackWarnings(result.settings.shadows, result.lights), warned);
}

/// Compares lights with an extent: how many of their points reach each pixel.
void compareExtents(const CompareOptions& options, const LoadedScene& loaded,
                    const std::vector<DrawSettings>& settings, lab::CompareTask& task) {
    std::erase_if(task.views, [&](lab::LabView& view) {
        const ExtentOptions& extents = options.view.lights.extents;
        if (task.lights.empty())
            view.light.extent = view.light.position.w != 0.0 ? extents.ofPoints : extents.ofSuns;
        return !(task.lights.empty() ? view.light : task.lights.front()).extent;
    });
    if (task.views.empty())
        throw Error(ExitStatus::usage,
                    "No view's first light has an extent: --light-radius and --light-size apply to "
                    "point lights, --sun-angle to directional ones.");
    ProgressBar bar;
    const auto results =
        lab::compareCounts(loaded, task, [&](double share, const std::string& doing) {
            bar.show(share, doing, stageOf(doing));
        });
    warnOfFallbacks(results);
    std::ostringstream text;
    text << std::left << std::setw(34) << "points of visible pixels" << std::right << std::setw(10)
         << "wrong, %" << std::setw(14) << "pixels wrong" << std::setw(12) << "beyond 1px"
         << std::setw(10) << "not tied";
    Json all = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const lab::WrongSums& sums = results[i].sums;
        text << "\n"
             << std::left << std::setw(34) << results[i].name << std::right << std::fixed
             << std::setprecision(5) << std::setw(10) << sums.percent() << std::setw(14)
             << sums.wrongPixels << std::setw(12) << sums.beyond1px << std::setw(10)
             << sums.beyond1pxNotTied;
        DrawSettings used = settings[i];
        used.render = results[i].settings;
        Json json = {{"name", results[i].name}, {"views", task.views.size()}};
        json.update(sumsJson(sums));
        json["settings"] = settingsJson(used);
        json["settings"].update(options.sceneJson(loaded.scene));
        json["by_view"] = Json::array();
        for (std::size_t v = 0; v < task.views.size(); ++v) {
            Json one = {{"name", task.views[v].name}};
            one.update(sumsJson(results[i].byView[v]));
            json["by_view"].push_back(std::move(one));
        }
        all.push_back(std::move(json));
    }
    printResult(text.str(), options.report);
    writeReport(all.size() == 1 ? all.front() : Json{{"results", all}}, options.report);
}

std::string tableOf(const std::vector<lab::CompareResult>& results) {
    std::ostringstream text;
    text << std::left << std::setw(34) << "percent of visible pixels" << std::right << std::setw(12)
         << "mask wrong" << std::setw(12) << "beyond 1px" << std::setw(13) << "image wrong"
         << std::setw(12) << "beyond 1px" << std::setw(10) << "not tied" << std::setw(12)
         << "at 1/" + std::to_string(1 << results.front().subpixelBits) + " px"
         << "\n";
    for (const lab::CompareResult& result : results) {
        const lab::WrongCounts& c = result.counts;
        text << std::left << std::setw(34) << result.name << std::right << std::fixed
             << std::setprecision(5) << std::setw(12)
             << lab::percent(c.wrongMaskPixels, c.visiblePixels) << std::setw(12)
             << lab::percent(c.wrongMaskBeyond1px, c.visiblePixels) << std::setw(13)
             << lab::percent(c.wrongImagePixels, c.visiblePixels) << std::setw(12)
             << lab::percent(c.wrongImageBeyond1px, c.visiblePixels) << std::setw(10)
             << c.beyond1pxNotTied << std::setw(12) << c.beyond1pxNotDeviceTied << "\n";
    }
    std::string table = text.str();
    table.pop_back();
    return table;
}

void compare(const CompareOptions& options, bool viewsTyped) {
    std::vector<DrawSettings> settings = {options.settings};
    for (const std::string& text : options.against)
        settings.push_back(settingsFrom(options.settings, text));
    LoadedScene loaded = options.load(shadingFor(settings), options.settings.render.shadows,
                                      drawOppositeVertices(settings));
    if (std::ranges::any_of(settings, [](const DrawSettings& one) {
            return one.render.shadows == ShadowMethod::primitiveMap;
        }))
        holdStill(loaded.scene);
    printWarnings(loaded.scene.warnings.sentences());

    lab::CompareTask task;
    lookAt(task, options.view, loaded.scene, options.views, viewsTyped);
    task.limits = options.glLimits;
    for (const DrawSettings& one : settings)
        requireMapKind(one, task.lights);
    task.contenders.push_back(contenderOf(shortName(settings[0]), settings[0], nullptr));
    CasterVariants variants(options.input, loaded);
    for (std::size_t i = 0; i < options.against.size(); ++i)
        task.contenders.push_back(contenderOf(options.against[i], settings[i + 1],
                                              variants.with(settings[i + 1].casters)));

    if (options.view.lights.extents.typed()) {
        if (!options.heatmap.empty())
            throw Error(ExitStatus::usage,
                        "--heatmap shows a single mask, but a light with an extent has many.");
        return compareExtents(options, loaded, settings, task);
    }
    for (const DrawSettings& one : settings)
        requireExtents(one, {});
    ProgressBar bar;
    const auto results = lab::compareAll(loaded, task, [&](double share, const std::string& doing) {
        bar.show(share, doing, stageOf(doing));
    });
    warnOfFallbacks(results);
    if (!options.heatmap.empty())
        writeFile(options.heatmap, encodePng(results[0].heatmap, task.width, task.height));
    printResult(tableOf(results), options.report);
    const auto jsonOf = [&](std::size_t i) {
        Json json = resultJson(results[i], settings[i], variants.settingsWith(settings[i].casters),
                               task.views);
        json["settings"]["gl-limits"] = glLimitsName(options.glLimits);
        json["settings"].update(options.sceneJson(loaded.scene));
        return json;
    };
    Json json = jsonOf(0);
    if (results.size() > 1) {
        Json all = Json::array();
        for (std::size_t i = 0; i < results.size(); ++i)
            all.push_back(jsonOf(i));
        json = {{"results", std::move(all)}};
    }
    writeReport(json, options.report);
}

} // namespace

void addCompareCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("compare", "Count the pixels that a ray-traced oracle calls wrong");
    const auto options = std::make_shared<CompareOptions>();
    addSceneFile(*verb, *options)->required();
    CLI::Option* const views = addNumber(*verb, "--views", options->views);
    addText(*verb, "--heatmap", options->heatmap);
    addTexts(*verb, "--against", options->against);
    addSceneOptions(*verb, *options);
    addDrawOptions(*verb, options->settings);
    addText(*verb, "--report", options->report);
    verb->callback([options, views] {
        resolve(options->settings);
        options->view.lights.sun.requireUp();
        compare(*options, views->count() > 0);
    });
}

} // namespace edgeshade::cli
