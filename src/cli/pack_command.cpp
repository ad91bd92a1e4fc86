#include "preprocess/packing/pack.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/cli/summary.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

struct PackOptions {
    std::string input;
    std::string output;
    std::string report;
    Encoding encoding = Encoding::none;
    CasterOptions casters;
    ReadingLimits limits;
};

void pack(const PackOptions& options) {
    PackInput input = readForPacking(options.input, options.casters.settings(), options.limits);
    const Bytes bytes = packBytes(input, options.encoding);
    printWarnings(input.report.warnings);
    writeFile(options.output, bytes);
    printResult(summaryOf(input.report), options.report);
    writeReport(toJson(input.report), options.report);
}

} // namespace

void addPackCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("pack", "Add shadow data to a glTF scene; any viewer opens the GLB");
    const auto options = std::make_shared<PackOptions>();
    verb->add_option("IN", options->input, "The scene, .gltf or .glb")->required();
    verb->add_option("OUT", options->output, "The packed scene, .glb")->required();
    addWords(*verb, "--encoding", options->encoding,
             std::vector{Encoding::none, Encoding::indexed, Encoding::expanded});
    addCasterOptions(*verb, options->casters);
    addLimitOptions(*verb, options->limits);
    addText(*verb, "--report", options->report);
    verb->callback([options] { pack(*options); });
}

} // namespace edgeshade::cli
