// edgeshade_documents man|bash|words [OUT]: prints the manual page, the completion for bash, or the
// words of the command line that tests/stable keeps. Builds run it; it isn't installed.
#include "src/cli/bash_completion.hpp"
#include "src/cli/manual_page.hpp"
#include "src/cli/option_table.hpp"
#include "src/cli/program.hpp"

#include <fstream>
#include <iostream>

namespace {

using namespace edgeshade::cli;

/// A line for each verb, its files, its options and each value: "render --shadows WORD = map".
std::string stableWords(const CLI::App& program) {
    std::string text;
    for (const CLI::App* verb : program.get_subcommands(nullptr)) {
        const std::string& name = verb->get_name();
        text += name + "\n";
        for (const CLI::Option* file : verb->get_options())
            if (file->get_positional())
                text += name + " " + file->get_name(true) +
                        (file->get_required() ? "" : " (may be left out)") + "\n";
        for (const OptionGroup& group : optionTable())
            for (const Option& option : group.options) {
                if (!(option.where.verbs & verbOf(name))) continue;
                const std::string line =
                    name + " " + option.name + (option.type.empty() ? "" : " " + option.type);
                text += line + "\n";
                if (option.setsDefault())
                    text += line + " by default " + option.defaultText() + "\n";
                for (const std::string& word : option.values.words)
                    text += line + " = " + word + "\n";
                if (option.values.interval)
                    text += line + " = " + Values{{}, option.values.interval}.text() + "\n";
            }
    }
    for (const StatusMeaning& row : statusMeanings)
        text +=
            "exit status " + std::to_string(row.status) + ": " + std::string(row.meaning) + "\n";
    return text;
}

} // namespace

int main(int argc, char** argv) {
    const std::string wanted = argc == 2 || argc == 3 ? argv[1] : "";
    const auto program = makeProgram();
    std::string text;
    if (wanted == "man")
        text = manualPage(*program);
    else if (wanted == "bash")
        text = bashCompletion(*program);
    else if (wanted == "words")
        text = stableWords(*program);
    else {
        std::cerr << "edgeshade_documents takes man, bash or words, not '" << wanted << "'.\n";
        return 1;
    }
    if (argc == 2) {
        std::cout << text;
        return 0;
    }
    std::ofstream file(argv[2], std::ios::binary);
    if (file << text << std::flush) return 0;
    std::cerr << argv[2] << " can't be written.\n";
    return 4;
}
