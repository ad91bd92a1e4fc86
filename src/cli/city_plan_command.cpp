#include "preprocess/base/error.hpp"
#include "preprocess/base/file_io.hpp"
#include "src/city/plan_file.hpp"
#include "src/city/planning.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/report.hpp"
#include "src/cli/sun_options.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

namespace fs = std::filesystem;

struct CityPlanOptions {
    std::string input, output;
    DayOptions days;
    int step{};                ///< minutes
    city::PlanChoice choice{}; ///< without what `days` and `step` say

    city::PlanChoice chosen() const {
        if (!days.from)
            throw Error(ExitStatus::usage, "city plan needs --date, or --from and --to.");
        city::PlanChoice chosen = choice;
        chosen.schedule.from = *days.from;
        chosen.schedule.to = *days.to;
        chosen.schedule.step = std::chrono::minutes(step);
        chosen.offset = days.offset;
        return chosen;
    }
};

void plan(const CityPlanOptions& options) {
    const city::PlanChoice choice = options.chosen();
    // Wrong days are found before the city is read.
    hours::positionsOf(choice.schedule);
    ProgressBar bar;
    std::vector<std::string> warnings;
    city::Plan plan = city::planOf(
        city::sourcesIn(options.input, choice.reading.limits), choice,
        [&](double share, const std::string& file) {
            bar.show(share, "reading " + file, "reading tiles");
        },
        warnings);
    bar.show(1.0, "planned");
    printWarnings(warnings);
    if (hours::positionsOf(plan.schedule).empty())
        printWarnings({"The sun is never higher than " +
                       CLI::detail::to_string(plan.schedule.minAltitude) +
                       " degrees on these days, so there are no hours of sun."});
    plan.folder =
        fs::proximate(fs::absolute(plan.folder), fs::absolute(options.output).parent_path());
    writeFile(options.output, city::textOf(plan));
    std::uint64_t most = 0;
    for (const city::Job& job : plan.jobs)
        most = std::max(most, job.memory);
    printResult(options.output + ": " + std::to_string(plan.sources.size()) + " tiles, " +
                    std::to_string(plan.region.columns()) + " x " +
                    std::to_string(plan.region.rows()) + " cells, " +
                    std::to_string(plan.jobs.size()) + " jobs of at most " +
                    std::to_string(most >> 20) + " MiB",
                "");
}

} // namespace

void addCityPlanCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("city-plan", "Divide a city into jobs that count hours of sunlight");
    const auto options = std::make_shared<CityPlanOptions>();
    CityPlanOptions& of = *options;
    city::PlanChoice& choice = of.choice;
    verb->add_option("CITY", of.input, "A folder of tiles, a .txt that lists them, or one tile")
        ->required();
    addText(*verb, "--output", of.output)->required();
    CLI::Option* const place = addOption(*verb, "--place", [&choice](const std::string& text) {
        choice.placeFromSources = text == "auto";
        if (choice.placeFromSources) return;
        const auto at = numbersFrom<2>(text, "--place", "auto or of the form LAT,LON");
        choice.schedule.place = readAs("--place", [&] { return sun::placeAt(at[0], at[1]); });
    });
    addNumber(*verb, "--north", choice.schedule.north)->needs(place);
    addDayOptions(*verb, of.days);
    addNumber(*verb, "--step", of.step);
    addNumber(*verb, "--min-altitude", choice.schedule.minAltitude);
    addNumber(*verb, "--grid", choice.grid);
    addNumber(*verb, "--lod", choice.reading.lod);
    addNumber(*verb, "--memory", choice.memory);
    addNumber(*verb, "--tiles", choice.tiles);
    verb->add_flag("--months", choice.months);
    verb->add_flag("--bits", choice.bits);
    verb->callback([options] { plan(*options); });
}

} // namespace edgeshade::cli
