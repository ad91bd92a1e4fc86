#include "src/cli/sunhours_surfaces.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/reading/scene_names.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/report.hpp"
#include "src/cli/scene_hash.hpp"
#include "src/cli/sensor_rays.hpp"
#include "src/cli/surface_choice.hpp"
#include "src/cli/surface_files.hpp"
#include "src/hours/beam.hpp"
#include "src/hours/surfaces/bits_npy.hpp"
#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/left_out_cells.hpp"
#include "src/hours/surfaces/surface_report.hpp"
#include "src/hours/surfaces/windows.hpp"

#include <algorithm>
#include <cstdio>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Days from which tables have columns by month.
constexpr std::size_t daysOfYear = 365;

/// Shares of the progress bar at which stages begin.
constexpr double raysFrom = 0.05, filesFrom = 0.95;

/// Distance from its plane that a window's pane may have, in metres.
constexpr double flatPane = 0.01;

hours::SurfaceCells divide(const SunHoursOptions& options, const LoadedScene& loaded,
                           const hours::SensorLight& light) {
    const SurfaceOptions& typed = options.surface;
    const double scale = 1.0 / typed.unit;
    const hours::SurfaceChoice choice =
        surfaceChoice(*loaded.document, typed.nodes, typed.materials, typed.windows);
    std::optional<double> rise = options.riseInWindows();
    if (rise) *rise *= scale;
    hours::SurfaceCells cells =
        typed.windows.empty()
            ? hours::cellsOf(loaded.scene, choice, {typed.grid * scale, typed.offset * scale})
            : hours::windowsOf(loaded.scene, choice, {flatPane * scale, typed.offset * scale, rise},
                               light);
    if (cells.cells.empty())
        throw Error(ExitStatus::usage, "--surfaces: there is no surface of that choice.");
    hours::markLeftOut(cells, hours::solidSurfaces(loaded.scene, loaded.settings.castMasked));
    return cells;
}

void addNames(const LoadedScene& loaded, hours::SurfaceRun& run) {
    for (const hours::WorldTriangle& triangle : run.cells.triangles) {
        if (!run.nodes.contains(triangle.node))
            run.nodes[triangle.node] = nodeTitle(*loaded.document, triangle.node);
        if (!run.materials.contains(triangle.material))
            run.materials[triangle.material] = materialTitle(*loaded.document, triangle.material);
    }
}

hours::LightQuestion questionOf(const SunHoursOptions& options, const hours::Schedule& schedule,
                                const hours::SurfaceRun& run, const std::vector<double>& beam) {
    hours::LightQuestion question;
    question.normalIrradiance = beam;
    question.positions = run.positions;
    question.step = schedule.step;
    question.offset = schedule.offset;
    question.months = schedule.days() >= daysOfYear;
    question.bits =
        run.ofWindows || std::ranges::any_of(options.files.all(), [](const std::string& path) {
            return surfaceFileOf(path) == SurfaceFile::npy;
        });
    const std::size_t rows = run.cells.cells.size(),
                      bytes = hours::bytesOfRow(run.positions.size());
    if (question.bits && bytes > 0 && rows > hours::mostBytesOfBits / bytes)
        throw Error(ExitStatus::usage,
                    "OUT: the .npy file of " + std::to_string(rows) + " cells and " +
                        std::to_string(run.positions.size()) +
                        " sun positions would exceed 4 GiB; take a larger --grid or a longer "
                        "--step.");
    return question;
}

/// "; 12 cells (3 m²) inside solids left out"; empty: there are none.
std::string leftOutText(const Json& of, const char* where) {
    if (of["cells"] == 0) return "";
    return "; " + std::to_string(of["cells"].get<std::size_t>()) + " cells (" +
           shortText(of["area"].get<double>()) + " m²) " + where + " left out";
}

std::string summaryOf(const hours::SurfaceRun& run, const Json& report) {
    char text[240];
    std::snprintf(text, sizeof text,
                  ": %zu %s on %.6g m², %zu sun positions, UTC%s; hours of sun %.4g to %.4g, "
                  "mean %.4g",
                  run.cells.cells.size(), run.ofWindows ? "windows" : "cells",
                  report["area"].get<double>(), run.positions.size(),
                  sun::textOf(run.offset).c_str(), report["hours"]["min"].get<double>(),
                  report["hours"]["max"].get<double>(), report["hours"]["mean"].get<double>());
    std::string all = text;
    if (report.contains("direct_kwh")) {
        const Json& energy = report["direct_kwh_per_m2"];
        std::snprintf(text, sizeof text,
                      "; direct beam alone %.4g to %.4g kWh/m², mean %.4g, %.6g kWh in all",
                      energy["min"].get<double>(), energy["max"].get<double>(),
                      energy["mean"].get<double>(), report["direct_kwh"].get<double>());
        all += text;
    }
    if (report.contains("area_above_threshold_percent")) {
        std::snprintf(text, sizeof text, "; the threshold is met on %.1f %% of the area",
                      report["area_above_threshold_percent"].get<double>());
        all += text;
    }
    if (report.contains("rule"))
        all += "; " + std::to_string(report["rule"]["passing"].get<std::size_t>()) + " of " +
               std::to_string(report["rule"]["checks"].size()) + " " +
               report["rule"]["of"].get<std::string>() + " pass";
    return all + leftOutText(report["inside_solids"], "inside solids") +
           leftOutText(report["within_others"], "on others");
}

} // namespace

void sunHoursOfSurfaces(const SunHoursOptions& options) {
    for (const std::string& path : options.files.all())
        surfaceFileOf(path);
    if (options.by == SunHoursBy::masks)
        throw Error(ExitStatus::usage,
                    "--by masks does not go with --surfaces, which only rays can measure.");
    const hours::Schedule schedule = options.schedule();
    hours::SurfaceRun run;
    run.positions = hours::positionsOf(schedule);
    run.step = schedule.step;
    run.offset = schedule.offset;
    run.unit = options.surface.unit;
    run.ofWindows = !options.surface.windows.empty();

    const std::vector<double> beam = options.surface.quantity == Quantity::directKwh
                                         ? hours::beamOf(*options.weather, run.positions, run.step)
                                         : std::vector<double>();

    const LoadedScene loaded = options.loadForHours(schedule, run.positions, true);
    ProgressBar bar;
    bar.show(0.0, "dividing surfaces");
    const hours::SensorLight light = sensorLight(loaded);
    run.cells = divide(options, loaded, light);
    addNames(loaded, run);
    run.settings = options.settingsJson(schedule, loaded.scene);
    run.settings["surfaces"] = options.surface.json();
    run.scene = hashOf(loaded.scene);
    run.version = EDGESHADE_VERSION;
    run.files = filesJson(*loaded.document, options.limits.fileBytes);
    run.warnings = loaded.scene.warnings.sentences();

    const std::string doing = std::to_string(run.cells.cells.size()) + " cells, " +
                              std::to_string(run.positions.size()) + " sun positions";
    run.light = hours::lightOf(run.cells, questionOf(options, schedule, run, beam),
                               sensorLight(loaded), [&](double share) {
                                   bar.show(raysFrom + (filesFrom - raysFrom) * share,
                                            "tracing rays to " + doing, "tracing rays to " + doing);
                               });

    bar.show(filesFrom, "making files");
    // Make everything before writing anything.
    const hours::HoursSettings settings =
        hours::hoursSettings(JsonField(options.input, run.settings, "settings"));
    const Json report = hours::surfaceReportOf(run, settings);
    std::vector<MadeFile> files;
    for (const std::string& path : options.files.all())
        files.push_back(makeSurfaceFile(path, run, options.surface.when));
    if (isPage(options.files.report))
        files.push_back(makePage(options.files.report, run, settings, report, loaded.scene));
    for (const MadeFile& file : files)
        writeFile(file.path, file.bytes);
    bar.show(1.0, "done");
    printResult(options.files.picture + summaryOf(run, report), options.files.report);
    if (!isPage(options.files.report)) writeReport(report, options.files.report);
}

} // namespace edgeshade::cli
