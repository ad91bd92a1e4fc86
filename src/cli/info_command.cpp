#include "preprocess/base/stopwatch.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/pack.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/cli/summary.hpp"
#include "src/image/image_choice.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

struct InfoOptions {
    std::string input;
    std::string report;
    CasterOptions casters;
    ReadingLimits limits;
};

void info(const InfoOptions& options) {
    Stopwatch watch;
    GltfDocument document = readGltf(options.input, options.limits);
    const auto header = readShadowHeader(document);
    const double readSeconds = watch.lap();
    const CasterSettings settings =
        options.casters.wanted().value_or(header ? header->settings : CasterSettings());
    PackInput input = readForPacking(std::move(document), settings, true);
    input.report.readSeconds += readSeconds;
    decodeImages(input.document, input.scene); // for its warnings
    input.report.warnings = input.scene.warnings.sentences();
    printWarnings(input.report.warnings);
    std::string text = summaryOf(input.report);
    text += std::string("\npacked                    ") +
            (header ? std::string("yes, ") + nameOf(header->encoding) : "no");
    text += choicesOf(input.report);
    printResult(text, options.report);
    auto report = toJson(input.report);
    report["encoding"] = header ? nlohmann::ordered_json(nameOf(header->encoding)) : nullptr;
    writeReport(report, options.report);
}

} // namespace

void addInfoCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand("info", "List the contents of a scene, packed or not");
    const auto options = std::make_shared<InfoOptions>();
    verb->add_option("FILE", options->input, "The scene, .gltf or .glb")->required();
    addCasterOptions(*verb, options->casters);
    addLimitOptions(*verb, options->limits);
    addText(*verb, "--report", options->report);
    verb->callback([options] { info(*options); });
}

} // namespace edgeshade::cli
