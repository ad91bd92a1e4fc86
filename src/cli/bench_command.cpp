#include "preprocess/base/error.hpp"
#include "src/bench/bench.hpp"
#include "src/bench/scattered_lights.hpp"
#include "src/cli/bench_report.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/cli/synthetic_report.hpp"

#include <charconv>
#include <memory>
#include <set>
#include <sstream>

namespace edgeshade::cli {
namespace {

struct BenchOptions : SceneOptions {
    std::string report;
    bool synthetic = false;
    int frames = 0; ///< 0: defaultFrames, or SyntheticTask's
    int warmUp{};
    std::vector<std::pair<int, int>> sizes; ///< of --sizes; else view's
    std::vector<std::size_t> lightCounts;   ///< of --lights; none: the scene's or the call's
    bool lightMoves = false;
    double circle{};
    std::optional<gl::Timing> timing;
    DrawSettings settings;
    int samples = 0;
    std::vector<std::string> against;
};

constexpr int defaultFrames = 120;
constexpr int defaultRepeats = 9;

/// The sizes of the thesis' measurements.
const std::vector<std::pair<int, int>> allSizes = {
    {800, 600}, {1920, 1080}, {2560, 1600}, {3840, 2160}};

std::vector<std::pair<int, int>> sizesFrom(const std::string& text) {
    if (text == "all") return allSizes;
    std::vector<std::pair<int, int>> sizes;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');)
        sizes.push_back(sizeFrom(part, "--sizes"));
    if (sizes.empty()) sizes.push_back(sizeFrom(text, "--sizes"));
    return sizes;
}

/// Parses "1,4,16"; throws for anything else.
std::vector<std::size_t> lightCountsFrom(const std::string& text) {
    std::vector<std::size_t> counts;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), count);
        if (error != std::errc() || end != part.data() + part.size() || count < 1 ||
            count > mostLights)
            throw CLI::ValidationError(
                "--lights", "'" + text + "' is not file, default or a list of " +
                                "comma-separated numbers from 1 to " + std::to_string(mostLights));
        counts.push_back(count);
    }
    return counts;
}

/// Takes numbers, too: lights that are scattered.
void replaceLightsOption(CLI::App& verb, BenchOptions& options) {
    verb.remove_option(verb.get_option("--lights"));
    CLI::Option* const lights = addOption(verb, "--lights", [&options](const std::string& text) {
        if (text == "file")
            options.view.lights.choice = LightChoice::file;
        else if (text == "default")
            options.view.lights.choice = LightChoice::fallback;
        else
            options.lightCounts = lightCountsFrom(text);
    });
    for (const char* typed : {"--light", "--sun", "--place"})
        lights->excludes(verb.get_option(typed));
}

void benchScene(const BenchOptions& options) {
    std::vector<BenchSetting> settings = {{shortName(options.settings), options.settings, nullptr}};
    for (const std::string& text : options.against)
        settings.push_back({text, settingsFrom(options.settings, text), nullptr});
    const LoadedScene loaded =
        options.load(shadingFor(settings, &BenchSetting::settings), options.settings.render.shadows,
                     drawOppositeVertices(settings, &BenchSetting::settings));
    CasterVariants variants(options.input, loaded);
    for (BenchSetting& setting : settings)
        setting.scene = variants.with(setting.settings.casters);
    BenchReport report;
    report.casters = loaded.settings;
    report.scene = options.sceneJson(loaded.scene);
    report.warnings = loaded.scene.warnings.sentences();
    printWarnings(report.warnings);

    const auto sizes = options.sizes.empty()
                           ? std::vector{std::pair(options.view.width, options.view.height)}
                           : options.sizes;
    std::set<std::string> fallbacks; // warn once per light, whatever the picture's size
    Countdown countdown;
    const auto counts =
        options.lightCounts.empty() ? std::vector<std::size_t>{0} : options.lightCounts;
    const std::size_t rounds = sizes.size() * counts.size();
    for (std::size_t s = 0; s < rounds; ++s) {
        const std::size_t count = counts[s % counts.size()]; // 0: the scene's lights or those typed
        ViewOptions view = options.view;
        std::tie(view.width, view.height) = sizes[s / counts.size()];
        bench::Task task;
        task.width = view.width;
        task.height = view.height;
        task.samples = options.samples;
        task.limits = options.glLimits;
        task.frames = options.frames > 0 ? options.frames : defaultFrames;
        task.warmUp = options.warmUp;
        task.frustumAt = flightFor(view, loaded.scene);
        task.scattered = count > 0;
        task.lights = task.scattered ? bench::scatterLights(loaded.scene, count)
                                     : requestFor(view, loaded.scene).lights;
        if (task.scattered && view.lights.extents.typed()) view.lights.extents.giveTo(task.lights);
        for (const BenchSetting& setting : settings) {
            requireExtents(setting.settings, task.lights);
            requireMapKind(setting.settings, task.lights);
        }
        task.lightMoves = options.lightMoves;
        task.circle = options.circle;
        task.near = view.depth.near;
        task.timing = options.timing;
        for (const BenchSetting& setting : settings)
            task.settings.push_back(toTask(setting));
        const std::string size =
            std::to_string(view.width) + "x" + std::to_string(view.height) + " pixels" +
            (task.scattered ? ", lights: " + std::to_string(count) : std::string());
        const bench::Report measured = bench::measure(loaded, task, [&](double share) {
            countdown.show((static_cast<double>(s) + share) / static_cast<double>(rounds), size);
        });
        report.add(task, settings, measured);
        for (std::size_t i = 0; i < measured.results.size(); ++i)
            printNewWarnings(
                fallbackWarnings(settings[i].settings.render.shadows, measured.results[i].lights),
                fallbacks);
    }
    printWarnings(report.warningsOfMeasuring());
    printResult(report.table(), options.report);
    writeReport(report.json(), options.report);
}

void benchSynthetic(const BenchOptions& options) {
    bench::SyntheticTask task;
    if (options.frames > 0) task.turns = options.frames;
    if (options.settings.has("--multiplicity")) task.method = options.settings.render.multiplicity;
    if (task.method == MultiplicityMethod::plane)
        throw Error(ExitStatus::usage, "--multiplicity plane does not go with --synthetic, whose "
                                       "opposite-vertex layouts have no planes.");
    task.timing = options.timing;
    Countdown countdown;
    const bench::SyntheticReport measured = bench::measureSynthetic(
        task, [&](double share, const std::string& doing) { countdown.show(share, doing); });
    if (measured.device.isSoftware()) printWarnings({softwareWarning(measured.device)});
    printResult(syntheticTable(measured), options.report);
    writeReport(syntheticJson(measured, task.method), options.report);
}

/// A synthetic mesh is never shown, so --synthetic takes no options for pictures.
void bench(const BenchOptions& options, const CLI::App& verb) {
    if (options.synthetic == !options.input.empty())
        throw Error(ExitStatus::usage, options.synthetic ? "--synthetic takes no FILE."
                                                         : "bench needs a FILE, or --synthetic.");
    if (!options.synthetic) return benchScene(options);
    for (const CLI::Option* option : verb.get_options()) {
        const std::string name = option->get_name();
        const bool fits = name == "--synthetic" || name == "--frames" || name == "--timing" ||
                          name == "--multiplicity" || name == "--report" || name == "--help";
        if (option->count() > 0 && !fits)
            throw Error(ExitStatus::usage, name + " does not go with --synthetic.");
    }
    benchSynthetic(options);
}

} // namespace

void addBenchCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("bench", "Time the frames of a flight through a scene, by stage");
    const auto options = std::make_shared<BenchOptions>();
    addSceneFile(*verb, *options);
    verb->add_flag("--synthetic", options->synthetic);
    addNumber(*verb, "--frames", options->frames);
    addNumber(*verb, "--warm-up", options->warmUp);
    verb->add_flag("--light-moves", options->lightMoves);
    addNumber(*verb, "--light-circle", options->circle)->needs("--light-moves");
    CLI::Option* const sizes = addOption(
        *verb, "--sizes", [options](const std::string& text) { options->sizes = sizesFrom(text); });
    addTexts(*verb, "--against", options->against);
    addWords(*verb, "--timing", options->timing, timings);
    addSceneOptions(*verb, *options);
    replaceLightsOption(*verb, *options);
    sizes->excludes(verb->get_option("--size"));
    addDrawOptions(*verb, options->settings);
    addNumber(*verb, "--samples", options->samples);
    addText(*verb, "--report", options->report);
    verb->callback([options, verb] {
        resolve(options->settings);
        options->view.lights.sun.requireUp();
        bench(*options, *verb);
    });
}

} // namespace edgeshade::cli
