#include "src/cli/surface_results.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/surface_files.hpp"
#include "src/hours/surfaces/bits_npy.hpp"
#include "src/hours/surfaces/surface_report.hpp"

#include <algorithm>
#include <cstdio>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

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

bool keepsBits(const SunHoursFiles& files) {
    return std::ranges::any_of(files.all(), [](const std::string& path) {
        return surfaceFileOf(path) == SurfaceFile::npy;
    });
}

void requireBitsFit(const SunHoursFiles& files, std::size_t cells, std::size_t positions) {
    const std::size_t row = hours::bytesOfRow(positions);
    if (keepsBits(files) && row > 0 && cells > hours::mostBytesOfBits / row)
        throw Error(ExitStatus::usage,
                    "OUT: the .npy file of " + std::to_string(cells) + " cells and " +
                        std::to_string(positions) +
                        " sun positions would exceed 4 GiB; take a larger --grid or a longer "
                        "--step.");
}

void writeSurfaces(const hours::SurfacePart& whole, const std::string& source,
                   const SunHoursFiles& files, bool when, ProgressBar& bar) {
    const hours::SurfaceRun& run = whole.run;
    // Make everything before writing anything.
    const hours::HoursSettings settings =
        hours::hoursSettings(JsonField(source, run.settings, "settings"));
    const Json report = hours::surfaceReportOf(run, settings);
    std::vector<MadeFile> made;
    for (const std::string& path : files.all())
        made.push_back(makeSurfaceFile(path, run, when));
    if (isPage(files.report))
        made.push_back(makePage(files.report, run, settings, report, whole.scene));
    for (const MadeFile& file : made)
        writeFile(file.path, file.bytes);
    bar.show(1.0, "done");
    printResult(files.picture + summaryOf(run, report), files.report);
    if (!isPage(files.report)) writeReport(report, files.report);
}

} // namespace edgeshade::cli
