#include "preprocess/base/error.hpp"
#include "preprocess/base/file_io.hpp"
#include "src/city/city_files.hpp"
#include "src/city/geo_tiff.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/city_results.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/report.hpp"
#include "src/image/png.hpp"
#include "src/plot/color_scale.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

namespace fs = std::filesystem;

struct CityMergeOptions {
    std::string plan, results, output;
};

void writeText(const fs::path& path, const std::string& text) {
    writeFile(path, std::string_view(text));
}

void merge(const CityMergeOptions& options) {
    const city::ReadPlan read = city::planFrom(options.plan);
    ProgressBar bar;
    bar.show(0.0, "reading results");
    const city::CityMap map = city::mapOf(read, cityResultsOf(options.plan, options.results));
    bar.show(0.5, "making files");
    // Make everything that may fail before writing anything.
    const Bytes raster = city::geoTiffOf(map, read.plan);
    const Image preview = city::previewOf(map, plot::evenColor);
    const nlohmann::ordered_json report = city::mapReportOf(map, read.plan);
    const fs::path folder = options.output;
    std::error_code error;
    fs::create_directories(folder, error);
    for (std::size_t i = 0; i < read.plan.sources.size(); ++i) {
        const city::Source& source = read.plan.sources[i].source;
        if (source.kind != city::SourceKind::cityJson &&
            source.kind != city::SourceKind::cityJsonSequence)
            continue;
        const fs::path file = source.file;
        fs::create_directories(folder / file.parent_path(), error);
        writeText(folder / file.parent_path() / ("hours-" + file.filename().string()),
                  city::cityJsonWithHours(map, read.plan, i));
    }
    writeFile(folder / "hours.tif", raster);
    writeText(folder / "objects.csv", city::objectsCsvOf(map, read.plan));
    writeFile(folder / "preview.png", encodePng(preview.rgba, preview.width, preview.height));
    writeReport(report, (folder / "report.json").string());
    bar.show(1.0, "done");
    char text[160];
    std::snprintf(text, sizeof text,
                  ": %zu of %zu cells, %zu sun positions; hours of sun %.4g to %.4g, mean %.4g",
                  report["cells_with_surface"].get<std::size_t>(), map.lit.size(), map.positions,
                  report["hours"]["min"].get<double>(), report["hours"]["max"].get<double>(),
                  report["hours"]["mean"].get<double>());
    printResult(options.output + text, "");
}

} // namespace

void addCityMergeCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "city-merge", "Join the results of a city's jobs: raster, table, picture, report");
    const auto options = std::make_shared<CityMergeOptions>();
    verb->add_option("PLAN", options->plan, "The plan, .json")->required();
    verb->add_option("RESULTS", options->results, "Folder of the jobs' results; PLAN.jobs if none");
    addText(*verb, "--output", options->output)->required();
    verb->callback([options] { merge(*options); });
}

} // namespace edgeshade::cli
