#include "preprocess/base/error.hpp"
#include "preprocess/base/file_io.hpp"
#include "src/city/job.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/city_results.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/report.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

struct CityRunOptions {
    std::string plan, output;
    std::size_t job = 0;
};

void run(const CityRunOptions& options) {
    const city::ReadPlan plan = city::planFrom(options.plan);
    const std::filesystem::path folder = cityResultsOf(options.plan, options.output);
    ProgressBar bar;
    const city::JobResult result =
        city::runJob(plan, options.job, [&](double share, const std::string& doing) {
            bar.show(share, doing, doing);
        });
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path path = folder / city::fileNameOfJob(options.job);
    writeFile(path, city::bytesOfResult(result));
    bar.show(1.0, "done");
    printResult(path.string() + ": " + std::to_string(result.cells.count()) + " cells, " +
                    std::to_string(result.positions) + " sun positions",
                "");
}

} // namespace

void addCityRunCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand("city-run", "Compute one job of a city's plan");
    const auto options = std::make_shared<CityRunOptions>();
    verb->add_option("PLAN", options->plan, "The plan, .json")->required();
    addNumber(*verb, "--job", options->job)->required();
    addText(*verb, "--output", options->output);
    verb->callback([options] { run(*options); });
}

} // namespace edgeshade::cli
