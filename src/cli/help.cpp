#include "src/cli/help.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <map>
#include <sstream>
#include <vector>

namespace edgeshade::cli {
namespace {

/// An option as --help shows it.
struct Everyday {
    const char* option;   ///< with its value's name
    const char* sentence; ///< short enough for one line
};

constexpr std::array everyday{
    Everyday{"--size WxH", "Size of the picture in pixels (1920x1080)"},
    Everyday{"--camera NAME|INDEX", "One of the file's cameras; `edgeshade info` lists them"},
    Everyday{"--camera-from X,Y,Z", "Where the eye is (where it sees all of the scene)"},
    Everyday{"--camera-to X,Y,Z", "What the eye looks at (the middle of the scene)"},
    Everyday{"--fov DEG", "Vertical field of view in degrees (45)"},
    Everyday{"--ortho HEIGHT", "An orthographic picture, this many scene units high"},
    Everyday{"--sun X,Y,Z", "A sun, by the direction towards it; may be repeated"},
    Everyday{"--light X,Y,Z", "A lamp, by its place; may be repeated"},
    Everyday{"--light-radius R", "Lamps are spheres of this radius, with soft shadows"},
    Everyday{"--sun-angle DEG", "Suns are discs this wide, with soft shadows; ours is 0.53"},
    Everyday{"--place LAT,LON", "The sun as it stands over this place"},
    Everyday{"--time-of-day TIME", "When that is, for example 2026-06-21T14:30+02:00"},
    Everyday{"--north DEG", "Where north is, clockwise from -Z seen from above (0)"},
    Everyday{"--shadows METHOD", "auto, volumes, lookup, points, map or none"},
    Everyday{"--cast-cutouts", "Cut-out materials cast what their alpha leaves of them"},
    Everyday{"--ground KIND", "A plane under the scene: off, catcher or #RRGGBB"},
    Everyday{"--exposure EV", "Brighten the light 2^EV times (0)"},
    Everyday{"--environment FILE.hdr", "A picture of the surroundings, for ambient light"},
    Everyday{"--mask", "Only what the first light reaches: white lit, black in shadow"},
    Everyday{"--smooth N", "Smooth outlines and shadows by the mean of N pictures (1)"},
    Everyday{"--time S", "Pose the file's animation at this second"},
    Everyday{"--report FILE", "Write a JSON report; - is standard output"},
    Everyday{"--views N", "Number of views to judge (16)"},
    Everyday{"--against SETTING", "Also measure this setting, NAME=VALUE,...; may be repeated"},
    Everyday{"--heatmap OUT.png", "Picture of the wrong pixels in the worst view"},
    Everyday{"--frames N", "Number of frames to time"},
    Everyday{"--warm-up N", "Number of frames to draw before that"},
    Everyday{"--light-moves", "Move the lights in every frame"},
    Everyday{"--light-circle DEG", "How far they move"},
    Everyday{"--sizes", "Time several picture sizes"},
    Everyday{"--timing CLOCK", "Which clock times a frame"},
    Everyday{"--synthetic", "Time generated edges instead of a file"},
    Everyday{"--plot OUT", "Plot of time against error"},
    Everyday{"--budget-ms MS", "Longest frame that is allowed"},
    Everyday{"--max-wrong-percent P", "Most wrong pixels that are allowed"},
    Everyday{"--time-limit SECONDS", "How long measuring may take"},
    Everyday{"--largest-map N", "Largest shadow map that is tried"},
    Everyday{"--screenshot OUT.png", "Save one picture and close the window"},
    Everyday{"--sun-hours", "Show hours of sunlight over one day"},
    Everyday{"--date DATE", "One day, for example 2026-03-20"},
    Everyday{"--from DATE", "First of several days"},
    Everyday{"--to DATE", "Last of several days"},
    Everyday{"--step MIN", "Minutes between sun positions"},
    Everyday{"--hours A-B", "Count only these hours of the day"},
    Everyday{"--utc-offset OFFSET", "The clock's offset from UTC"},
    Everyday{"--threshold H", "Report the area that gets at least so many hours"},
    Everyday{"--preset NAME", "Dates, hours and threshold of a standard"},
    Everyday{"--plan", "Look straight down on all of the scene"},
    Everyday{"--at X,Y,Z", "Report the hours at this point; may be repeated"},
    Everyday{"--counts OUT.png", "Counted positions as a 16-bit picture"},
    Everyday{"--part K/N", "Count one of N parts; sunhours-merge joins them"},
    Everyday{"--encoding KIND", "How shadow data are stored: none, indexed or expanded"},
    Everyday{"--weld-tolerance D", "Join vertices closer than this (0)"},
    Everyday{"--flat-tolerance DEG", "Treat edges that bend no more than this as flat (0)"},
    Everyday{"--caster-error D", "Simplify shadow casters by up to this distance (0)"},
    Everyday{"--instances KIND", "Store repeated meshes once: auto, shared or repeated"},
    Everyday{"--cast-masked", "MASK and BLEND surfaces cast shadows of whole triangles"},
};

/// The content of one verb's --help.
struct VerbHelp {
    std::vector<std::string> options;
    std::string example;
};

const std::map<std::string, VerbHelp>& verbs() {
    static const std::map<std::string, VerbHelp> all{
        {"render",
         {{"--size",     "--camera",      "--camera-from", "--camera-to",    "--fov",
           "--ortho",    "--sun",         "--light",       "--light-radius", "--sun-angle",
           "--place",    "--time-of-day", "--shadows",     "--cast-cutouts", "--ground",
           "--exposure", "--environment", "--mask",        "--smooth",       "--time",
           "--report"},
          "edgeshade render house.glb house.png --sun 0.4,1,0.3 --ground catcher"}},
        {"compare",
         {{"--views", "--against", "--heatmap", "--size", "--camera", "--camera-from",
           "--camera-to", "--sun", "--light", "--light-radius", "--sun-angle", "--shadows",
           "--cast-cutouts", "--report"},
          "edgeshade compare house.glb --against shadows=map,map-size=2048"}},
        {"bench",
         {{"--frames", "--warm-up", "--light-moves", "--light-circle", "--sizes", "--against",
           "--timing", "--synthetic", "--size", "--sun", "--light", "--light-radius", "--shadows",
           "--report"},
          "edgeshade bench house.glb --light-moves --against shadows=map,map-size=2048"}},
        {"tradeoff",
         {{"--budget-ms", "--max-wrong-percent", "--plot", "--frames", "--views", "--largest-map",
           "--against", "--light-moves", "--timing", "--time-limit", "--size", "--sun", "--light",
           "--report"},
          "edgeshade tradeoff house.glb --budget-ms 16 --plot tradeoff.png"}},
        {"view",
         {{"--size",        "--camera",      "--camera-from",  "--camera-to",    "--fov",
           "--sun",         "--light",       "--light-radius", "--sun-angle",    "--place",
           "--time-of-day", "--north",       "--shadows",      "--cast-cutouts", "--ground",
           "--exposure",    "--environment", "--smooth",       "--sun-hours",    "--screenshot"},
          "edgeshade view house.glb --place 48.1,11.6 --time-of-day 2026-06-21T14:30+02:00"}},
        {"sunhours",
         {{"--place", "--date", "--from", "--to", "--step", "--hours", "--utc-offset", "--north",
           "--preset", "--threshold", "--plan", "--size", "--camera-from", "--camera-to", "--at",
           "--counts", "--part", "--report"},
          "edgeshade sunhours town.glb hours.png --place 48.1,11.6 --date 2026-03-20 --plan"}},
        {"sunhours-merge",
         {{"--counts", "--report"}, "edgeshade sunhours-merge hours.png part1.png part2.png"}},
        {"pack",
         {{"--encoding", "--weld-tolerance", "--flat-tolerance", "--caster-error", "--instances",
           "--cast-masked", "--report"},
          "edgeshade pack house.glb house.packed.glb"}},
        {"info", {{"--weld-tolerance", "--report"}, "edgeshade info house.glb"}},
    };
    return all;
}

/// The groups of --help-all, in their order.
struct Group {
    const char* title;
    std::vector<const char*> options;
};

const std::vector<Group>& groups() {
    static const std::vector<Group> all{
        {"Picture",
         {"--size", "--camera", "--camera-from", "--camera-to", "--camera-matrix", "--ortho",
          "--fov", "--near", "--plan", "--mask", "--smooth", "--samples", "--ground", "--variant",
          "--time", "--animation", "--cull", "--screenshot"}},
        {"Lights",
         {"--sun", "--light", "--lights", "--light-range", "--light-radius", "--light-size",
          "--light-direction", "--sun-angle", "--light-samples", "--shadowed-lights", "--place",
          "--time-of-day", "--north"}},
        {"Shadows",
         {"--shadows", "--cast-cutouts", "--cast-masked", "--mask-scale",
          "--primitive-map-memory"}},
        {"Materials and ambient light",
         {"--shading", "--ambient", "--environment", "--exposure", "--terminator"}},
        {"Meshes",
         {"--encoding", "--weld-tolerance", "--flat-tolerance", "--caster-error", "--instances"}},
        {"Hours of sun",
         {"--date", "--from", "--to", "--step", "--hours", "--utc-offset", "--min-altitude",
          "--threshold", "--preset", "--at", "--counts", "--part", "--sun-hours"}},
        {"Measuring and reports",
         {"--report", "--explain", "--against", "--views", "--heatmap", "--frames", "--warm-up",
          "--light-moves", "--light-circle", "--sizes", "--timing", "--plot", "--budget-ms",
          "--max-wrong-percent", "--time-limit", "--largest-map"}},
        {"Limits of what is read",
         {"--max-file", "--max-memory", "--max-triangles", "--max-nodes", "--max-node-depth"}},
        {"Shadow maps, to compare with",
         {"--map-size", "--map-bias", "--map-kind", "--cascades", "--filter", "--pcf", "--soft"}},
        {"Laboratory, to compare with",
         {"--layout", "--multiplicity", "--silhouette", "--count", "--planes", "--instancing",
          "--depth-slices", "--warp", "--shade-samples", "--synthetic", "--debug", "--gl-limits"}},
        {"Help", {"--help", "--help-all"}},
    };
    return all;
}

std::string nameIn(const Everyday& of) {
    const std::string option = of.option;
    return option.substr(0, option.find(' '));
}

std::string shortText(const CLI::App& verb, const VerbHelp& help) {
    constexpr int column = 26;
    std::ostringstream text;
    const auto line = [&](const std::string& left, const std::string& right) {
        text << "  " << std::left << std::setw(column - 2) << left << right << "\n";
    };
    text << verb.get_description() << "\nUsage: edgeshade " << verb.get_name() << " [OPTIONS]";
    for (const CLI::Option* option : verb.get_options())
        if (option->get_positional()) text << " " << option->get_name(true);
    text << "\n\n";
    for (const CLI::Option* option : verb.get_options())
        if (option->get_positional()) line(option->get_name(true), option->get_description());
    text << "\n";
    for (const std::string& name : help.options) {
        const auto found = std::ranges::find(everyday, name, nameIn);
        line(found->option, found->sentence);
    }
    text << "\nExample: " << help.example << "\nRun 'edgeshade " << verb.get_name()
         << " --help-all' for every option.\n";
    return text.str();
}

class HelpText : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        const auto verb = verbs().find(app->get_name());
        if (verb == verbs().end()) return CLI::Formatter::make_help(app, name, mode);
        return mode == CLI::AppFormatMode::All ? everything(*app, name)
                                               : shortText(*app, verb->second);
    }

  private:
    std::string everything(const CLI::App& verb, const std::string& program) const {
        std::ostringstream text;
        text << make_description(&verb) << make_usage(&verb, program) << make_positionals(&verb);
        std::vector<const CLI::Option*> others =
            verb.get_options([](const CLI::Option* option) { return !option->get_positional(); });
        for (const Group& group : groups()) {
            std::vector<const CLI::Option*> shown;
            for (const char* name : group.options)
                if (const CLI::Option* there = verb.get_option_no_throw(name)) {
                    shown.push_back(there);
                    std::erase(others, there);
                }
            if (!shown.empty()) text << make_group(group.title, false, shown);
        }
        if (!others.empty()) text << make_group("Others", false, others);
        return text.str() + "\n";
    }
};

/// Removed options, and their replacements.
const std::map<std::string, std::string>& removed() {
    static const std::map<std::string, std::string> all{
        {"--volume-scissors", "volumes are counted wherever they may be seen"},
        {"--ambient-target", "surfaces in shadow are drawn once more"},
        {"--caster-culling", "a light at rest is looked up instead: --shadows auto"},
        {"--cull-solids", "--cull auto leaves out backs of single-sided materials"},
        {"--volume-ends", "volumes end at the plane that they reach soonest"},
    };
    return all;
}

/// Number of letters to add, remove or change to turn one word into the other (Levenshtein's
/// distance).
std::size_t distanceBetween(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] =
                std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row.back();
}

} // namespace

void setHelp(CLI::App& program) {
    const auto formatter = std::make_shared<HelpText>();
    for (CLI::App* verb : program.get_subcommands(nullptr)) {
        verb->set_help_flag("-h,--help", "The options that most people need");
        verb->set_help_all_flag("--help-all", "Every option, by group");
        verb->formatter(formatter);
    }
}

std::string unknownOption(const CLI::App& verb, const std::vector<std::string>& words,
                          const CLI::ExtrasError& error) {
    const auto option =
        std::ranges::find_if(words, [](const std::string& word) { return word.starts_with("--"); });
    if (option == words.end()) return error.what() + std::string(".");
    const std::string name = option->substr(0, option->find('='));
    const std::string sentence = "There is no option " + name;
    if (const auto gone = removed().find(name); gone != removed().end())
        return sentence + " any more, as it did not pay: " + gone->second +
               " (docs/what-did-not-pay.md).";
    std::string nearest;
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const CLI::Option* known : verb.get_options())
        for (const std::string& long_ : known->get_lnames())
            if (const std::size_t distance = distanceBetween(name, "--" + long_);
                distance < least) {
                least = distance;
                nearest = "--" + long_;
            }
    return sentence + (nearest.empty() ? "; --help-all lists all." : "; is " + nearest + " meant?");
}

} // namespace edgeshade::cli
