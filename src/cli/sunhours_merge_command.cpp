#include "preprocess/base/error.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/report.hpp"
#include "src/cli/sunhours_files.hpp"
#include "src/cli/sunhours_options.hpp"
#include "src/cli/surface_files.hpp"
#include "src/cli/surface_results.hpp"
#include "src/hours/merge.hpp"
#include "src/hours/part_file.hpp"
#include "src/hours/part_json.hpp"
#include "src/hours/surfaces/surface_merge.hpp"
#include "src/hours/surfaces/surface_part_file.hpp"

#include <algorithm>
#include <memory>

namespace edgeshade::cli {
namespace {

/// Shares of the progress bar at which all parts are read, and joined.
constexpr double allRead = 0.6, allJoined = 0.95;

struct MergeOptions {
    SunHoursFiles files;
    std::vector<std::string> parts;
    bool when = false;
};

/// Reads all parts, and calls use(path, JSON) for each.
template <class Use>
void forEachPart(const MergeOptions& options, ProgressBar& bar, const Use& use) {
    std::size_t read = 0;
    for (const std::string& path : options.parts) {
        bar.show(allRead * static_cast<double>(read++) / static_cast<double>(options.parts.size()),
                 "reading " + path, "reading " + std::to_string(options.parts.size()) + " parts");
        use(path, hours::partJsonFrom(path));
    }
}

void mergePictures(const MergeOptions& options) {
    requireJsonReport(options.files);
    if (options.when)
        throw Error(ExitStatus::usage, "--when needs parts of --surfaces, merged into a .csv.");
    std::vector<hours::PartOfFile> parts;
    ProgressBar bar;
    forEachPart(options, bar, [&](const std::string& path, const nlohmann::ordered_json& json) {
        if (hours::isSurfacePart(json))
            throw InputError("'" + path +
                             "' is a part of --surfaces, whose files end in .glb, .csv or .npy; "
                             "OUT is '" +
                             options.files.picture + "'.");
        parts.push_back({path, hours::partFrom(path, json)});
    });
    const hours::Part whole = hours::merged(parts);
    bar.show(1.0, "merged");
    printWarnings(whole.warnings);
    writeSunHours(whole, options.parts.front(), options.files);
}

void mergeSurfaces(const MergeOptions& options) {
    if (!options.files.counts.empty())
        throw Error(ExitStatus::usage,
                    "--counts needs parts of a picture; OUT is '" + options.files.picture + "'.");
    hours::SurfaceMerge merge;
    ProgressBar bar;
    forEachPart(options, bar, [&](const std::string& path, const nlohmann::ordered_json& json) {
        if (!hours::isSurfacePart(json))
            throw InputError("'" + path + "' is not a part of --surfaces, but OUT is '" +
                             options.files.picture + "'.");
        merge.add(path, hours::surfacePartFrom(path, json));
    });
    requireBitsFit(options.files, merge.cells(), merge.positions());
    const hours::SurfacePart whole =
        std::move(merge).whole(keepsBits(options.files), [&](double share) {
            bar.show(allRead + (allJoined - allRead) * share, "joining cells");
        });
    bar.show(allJoined, "making files");
    writeSurfaces(whole, options.parts.front(), options.files, options.when, bar);
    printWarnings(whole.run.warnings);
}

/// Moves files of surfaces at the beginning of the parts to those that are written.
void merge(MergeOptions options) {
    if (!isSurfaceFile(options.files.picture)) return mergePictures(options);
    const auto firstPart = std::ranges::find_if_not(options.parts, isSurfaceFile);
    options.files.more.assign(options.parts.begin(), firstPart);
    options.parts.erase(options.parts.begin(), firstPart);
    if (options.parts.empty())
        throw Error(ExitStatus::usage, "PARTS: sunhours-merge needs the parts of a run.");
    mergeSurfaces(options);
}

} // namespace

void addSunHoursMergeCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand(
        "sunhours-merge",
        "Join the parts of a run of sunhours: the same bytes as those of a whole run");
    const auto options = std::make_shared<MergeOptions>();
    verb->add_option("OUT", options->files.picture,
                     "The picture, .png; of --surfaces one or more of .glb, .csv, .npy")
        ->required();
    verb->add_option("PARTS", options->parts, "All parts of the run, in any order")->required();
    addSunHoursFileOptions(*verb, options->files);
    verb->add_flag("--when", options->when);
    verb->callback([options] { merge(*options); });
}

} // namespace edgeshade::cli
