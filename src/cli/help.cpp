#include "src/cli/help.hpp"

#include "src/cli/option_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <vector>

namespace edgeshade::cli {
namespace {

/// An example of a verb, and the group of options that its --help begins with.
struct Example {
    std::string_view verb, words;
    std::string_view firstGroup{};
};

constexpr std::array examples{
    Example{"pack", "house.glb house.packed.glb", "Meshes"},
    Example{"info", "house.glb", "Meshes"},
    Example{"render", "house.glb house.png --sun 0.4,1,0.3 --ground catcher"},
    Example{"compare", "house.glb --against shadows=map,map-size=2048", "Measuring and reports"},
    Example{"bench", "house.glb --light-moves --against shadows=map,map-size=2048",
            "Measuring and reports"},
    Example{"tradeoff", "house.glb --budget-ms 16 --plot tradeoff.png", "Measuring and reports"},
    Example{"sunhours", "town.glb hours.png --place 48.1,11.6 --date 2026-03-20 --plan",
            "Hours of sunlight"},
    Example{"sunhours-merge", "hours.png part1.png part2.png"},
    Example{"city-plan", "tiles --place auto --date 2026-03-20 --grid 1 -o plan.json",
            "Hours of sunlight"},
    Example{"city-run", "plan.json --job 1"},
    Example{"city-merge", "plan.json -o map"},
    Example{"view", "house.glb --place 48.1,11.6 --time-of-day 2026-06-21T14:30+02:00"},
};

constexpr std::size_t column = 25; // where explanations begin
constexpr std::size_t width = 100; // of lines

/// "  --size WxH   Size of the picture", in as many lines as it takes.
std::string lineOf(const std::string& left, const std::string& right) {
    std::string text, line = "  " + left;
    if (line.size() >= column) {
        text = line + "\n";
        line.clear();
    }
    line.resize(column, ' ');
    std::istringstream words(right);
    for (std::string word; words >> word;) {
        const bool isFirst = line.size() == column;
        if (!isFirst && line.size() + 1 + word.size() > width) {
            text += line + "\n";
            line.assign(column, ' ');
        } else if (!isFirst) {
            line += ' ';
        }
        line += word;
    }
    return text + line + "\n";
}

std::string headOf(const CLI::App& verb) {
    std::string usage = "Usage: edgeshade " + verb.get_name(), files;
    for (const CLI::Option* option : verb.get_options())
        if (option->get_positional()) {
            const std::string name = option->get_name(true);
            usage += option->get_required() ? " " + name : " [" + name + "]";
            files += lineOf(name, option->get_description());
        }
    return verb.get_description() + "\n" + usage + " [OPTIONS]\n\n" + files;
}

/// The names as typed, with what follows them.
std::string leftOf(const CLI::Option& option, const Option& row) {
    return option.get_name(false, true) + (row.type.empty() ? "" : " " + row.type);
}

std::string usualOptions(const CLI::App& verb, const Example& example) {
    std::string first, others;
    for (const OptionGroup& group : optionTable())
        for (const Option& row : group.options)
            if (row.where.brief & verbOf(verb.get_name()))
                (group.title == example.firstGroup ? first : others) +=
                    lineOf(leftOf(*verb.get_option(row.name), row), row.briefText(width - column));
    return headOf(verb) + "\n" + first + others + "\nExample: edgeshade " + verb.get_name() + " " +
           std::string(example.words) + "\nRun 'edgeshade " + verb.get_name() +
           " --help-all' for every option.\n";
}

std::string allOptions(const CLI::App& verb) {
    std::string text = headOf(verb);
    std::vector<const CLI::Option*> others =
        verb.get_options([](const CLI::Option* option) { return !option->get_positional(); });
    for (const OptionGroup& group : optionTable()) {
        std::string lines;
        for (const Option& row : group.options)
            if (const CLI::Option* option = verb.get_option_no_throw(row.name);
                option && (row.where.verbs & verbOf(verb.get_name()))) {
                lines += lineOf(leftOf(*option, row), row.fullText());
                std::erase(others, option);
            }
        if (!lines.empty()) text += "\n" + std::string(group.title) + ":\n" + lines;
    }
    for (const CLI::Option* option : others)
        text += "\nNot in the table: " + option->get_name() + "\n";
    return text;
}

class HelpText : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        const auto example = std::ranges::find(examples, app->get_name(), &Example::verb);
        if (example == examples.end()) return CLI::Formatter::make_help(app, name, mode);
        return mode == CLI::AppFormatMode::All ? allOptions(*app) : usualOptions(*app, *example);
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
        verb->set_help_flag("-h,--help");
        verb->set_help_all_flag("--help-all");
        verb->formatter(formatter);
    }
}

std::string_view exampleOf(std::string_view verb) {
    const auto example = std::ranges::find(examples, verb, &Example::verb);
    return example == examples.end() ? std::string_view() : example->words;
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
