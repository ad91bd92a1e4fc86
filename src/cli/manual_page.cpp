#include "src/cli/manual_page.hpp"

#include "edgeshade/version.hpp"
#include "src/cli/help.hpp"
#include "src/cli/option_table.hpp"
#include "src/cli/program.hpp"

namespace edgeshade::cli {
namespace {

/// Text that roff prints as it is: a backslash, a minus that can be copied, and a line that starts
/// with a dot or an apostrophe would be instructions.
std::string roff(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        const bool starts = escaped.empty() || escaped.back() == '\n';
        if (starts && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else
            escaped += c;
    }
    return escaped;
}

std::string bold(std::string_view text) {
    return "\\fB" + roff(text) + "\\fR";
}
std::string italic(std::string_view text) {
    return "\\fI" + roff(text) + "\\fR";
}

std::vector<const CLI::Option*> filesOf(const CLI::App& verb) {
    return verb.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

/// "edgeshade render FILE OUT [OPTIONS]"
std::string synopsisOf(const CLI::App& verb) {
    std::string line = bold("edgeshade " + verb.get_name());
    for (const CLI::Option* file : filesOf(verb)) {
        const std::string name = italic(file->get_name(true));
        line += file->get_required() ? " " + name : " [" + name + "]";
    }
    return line + " [" + italic("OPTIONS") + "]\n";
}

std::string entryOf(const CLI::App& verb) {
    std::string text =
        ".TP\n" + bold(verb.get_name()) + "\n" + roff(verb.get_description()) + ".\n";
    for (const CLI::Option* file : filesOf(verb))
        text +=
            ".br\n" + italic(file->get_name(true)) + ": " + roff(file->get_description()) + ".\n";
    return text + ".br\nExample: " + bold("edgeshade " + verb.get_name()) + " " +
           roff(exampleOf(verb.get_name())) + "\n";
}

std::string verbsWith(const Option& option) {
    std::string text;
    for (const std::string_view verb : verbNames)
        if (option.where.verbs & verbOf(verb)) text += (text.empty() ? "" : ", ") + bold(verb);
    return text;
}

std::string entryOf(const Option& option) {
    return ".TP\n" + bold(option.name) + (option.type.empty() ? "" : " " + italic(option.type)) +
           "\n" + roff(option.fullText()) + "\n.br\nVerbs: " + verbsWith(option) + ".\n";
}

} // namespace

std::string manualPage(const CLI::App& program) {
    std::string text = ".TH EDGESHADE 1 \"\" \"edgeshade " + std::string(versionText) +
                       "\" \"User Commands\"\n.SH NAME\n" +
                       "edgeshade \\- draw, measure and pack glTF scenes with pixel\\-exact "
                       "shadows\n.SH SYNOPSIS\n";
    std::string verbs;
    for (const CLI::App* verb : program.get_subcommands(nullptr)) {
        text += (verbs.empty() ? "" : ".br\n") + synopsisOf(*verb);
        verbs += entryOf(*verb);
    }
    text += ".SH DESCRIPTION\nInput is .gltf or .glb, packed or not. Progress and messages go to "
            "standard error, results to standard output.\n" +
            bold("edgeshade --version") + " prints the version.\n.SH VERBS\n" + verbs +
            ".SH OPTIONS\n";
    for (const OptionGroup& group : optionTable()) {
        text += ".SS " + roff(group.title) + "\n";
        for (const Option& option : group.options)
            text += entryOf(option);
    }
    text += ".SH EXIT STATUS\n";
    for (const StatusMeaning& row : statusMeanings)
        text += ".TP\n" + bold(std::to_string(row.status)) + "\n" + roff(row.meaning) + "\n";
    return text;
}

} // namespace edgeshade::cli
