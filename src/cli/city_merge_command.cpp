#include "src/city/merge.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/city_results.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/report.hpp"
#include "src/plot/color_scale.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

struct CityMergeOptions {
    std::string plan, results, output;
};

void merge(const CityMergeOptions& options) {
    const city::ReadPlan read = city::planFrom(options.plan);
    ProgressBar bar;
    const nlohmann::ordered_json report = city::mergeCity(
        read, cityResultsOf(options.plan, options.results), options.output, plot::evenColor,
        [&](double share) { bar.show(share * 0.99, "joining results"); });
    bar.show(1.0, "done");
    char text[160];
    std::snprintf(text, sizeof text,
                  ": %zu of %zu cells, %zu sun positions; hours of sun %.4g to %.4g, mean %.4g",
                  report["cells_with_surface"].get<std::size_t>(),
                  report["cells"].get<std::size_t>(), report["positions"].get<std::size_t>(),
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
