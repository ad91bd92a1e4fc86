#include "src/cli/commands.hpp"
#include "src/cli/report.hpp"
#include "src/cli/sunhours_files.hpp"
#include "src/cli/sunhours_options.hpp"
#include "src/hours/merge.hpp"
#include "src/hours/part_file.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

struct MergeOptions {
    SunHoursFiles files;
    std::vector<std::string> parts;
};

void merge(const MergeOptions& options) {
    requireJsonReport(options.files);
    std::vector<hours::PartOfFile> parts;
    ProgressBar bar;
    for (const std::string& path : options.parts) {
        bar.show(static_cast<double>(parts.size()) / static_cast<double>(options.parts.size()),
                 "reading " + path, "reading " + std::to_string(options.parts.size()) + " parts");
        parts.push_back({path, hours::partFrom(path)});
    }
    const hours::Part whole = hours::merged(parts);
    bar.show(1.0, "merged");
    printWarnings(whole.warnings);
    writeSunHours(whole, options.parts.front(), options.files);
}

} // namespace

void addSunHoursMergeCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "sunhours-merge",
        "Join the parts of a run of sunhours: the same bytes as those of a whole run");
    const auto options = std::make_shared<MergeOptions>();
    verb->add_option("OUT", options->files.picture, "The picture, .png")->required();
    verb->add_option("PARTS", options->parts, "All parts of the run, in any order")->required();
    addSunHoursFileOptions(*verb, options->files);
    verb->callback([options] { merge(*options); });
}

} // namespace edgeshade::cli
