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
    std::optional<sun::Place> place; ///< null: by the tiles
    std::optional<std::chrono::sys_days> date, from, to;
    std::optional<std::chrono::minutes> offset;
    int step = 10;
    double minAltitude = 5.0, north = 0.0, grid = 1.0;
    std::optional<double> lod;
    std::uint64_t memory = 0;
    std::size_t tiles = 1;
    bool months = false, bits = false;

    city::PlanChoice choice() const {
        city::PlanChoice choice;
        choice.reading.lod = lod;
        choice.placeFromSources = !place;
        choice.schedule.place = place.value_or(sun::Place());
        choice.schedule.north = north;
        choice.schedule.step = std::chrono::minutes(step);
        choice.schedule.minAltitude = minAltitude;
        if (!date && !from)
            throw Error(ExitStatus::usage, "city plan needs --date, or --from and --to.");
        choice.schedule.from = date ? *date : *from;
        choice.schedule.to = date ? *date : *to;
        choice.offset = offset;
        choice.grid = grid;
        choice.memory = memory;
        choice.tiles = tiles;
        choice.months = months;
        choice.bits = bits;
        return choice;
    }
};

void plan(const CityPlanOptions& options) {
    const city::PlanChoice choice = options.choice();
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
                       CLI::detail::to_string(options.minAltitude) +
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
    verb->add_option("CITY", of.input, "A folder of tiles, a .txt that lists them, or one tile")
        ->required();
    addText(*verb, "--output", of.output)->required();
    CLI::Option* const place = addOption(*verb, "--place", [&of](const std::string& text) {
        of.place.reset();
        if (text == "auto") return;
        const auto at = numbersFrom<2>(text, "--place", "auto or of the form LAT,LON");
        of.place = readAs("--place", [&] { return sun::placeAt(at[0], at[1]); });
    });
    addNumber(*verb, "--north", of.north)->needs(place);
    const auto addDate = [&](const std::string& name, std::optional<std::chrono::sys_days>& date) {
        return addOption(*verb, name, [&date, name](const std::string& text) {
            date = readAs(name, [&] { return sun::dateFromText(text); });
        });
    };
    CLI::Option* const date = addDate("--date", of.date);
    CLI::Option* const from = addDate("--from", of.from);
    CLI::Option* const to = addDate("--to", of.to);
    from->needs(to)->excludes(date);
    to->needs(from)->excludes(date);
    addNumber(*verb, "--step", of.step);
    addOption(*verb, "--utc-offset", [&of](const std::string& text) {
        of.offset = readAs("--utc-offset", [&] { return sun::offsetFromText(text); });
    });
    addNumber(*verb, "--min-altitude", of.minAltitude);
    addNumber(*verb, "--grid", of.grid);
    addNumber(*verb, "--lod", of.lod);
    addNumber(*verb, "--memory", of.memory);
    addNumber(*verb, "--tiles", of.tiles);
    verb->add_flag("--months", of.months);
    verb->add_flag("--bits", of.bits);
    verb->callback([options] { plan(*options); });
}

} // namespace edgeshade::cli
