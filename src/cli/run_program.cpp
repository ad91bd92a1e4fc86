#include "src/cli/run_program.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/help.hpp"
#include "src/cli/program.hpp"

#include <csignal>
#include <iostream>
#include <new>
#include <string_view>
#include <vector>

namespace edgeshade::cli {
namespace {

/// Prints one line, whatever characters a file's texts contain.
int fail(std::string sentence, ExitStatus status) {
    for (char& c : sentence)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    std::cerr << "edgeshade: " << sentence << std::endl;
    return static_cast<int>(status);
}

std::string verbsOf(const CLI::App& program) {
    std::string verbs;
    for (const CLI::App* verb : program.get_subcommands(nullptr))
        verbs += (verbs.empty() ? "" : ", ") + verb->get_name();
    return verbs;
}

/// Throws if the first word is neither a verb nor an option; CLI11 would say only that one is
/// missing.
void requireKnownVerb(const CLI::App& program, const std::vector<const char*>& words) {
    const std::string word = words.size() > 1 ? words[1] : "";
    if (word.starts_with('-')) return;
    for (const CLI::App* verb : program.get_subcommands(nullptr))
        if (verb->get_name() == word) return;
    throw Error(ExitStatus::usage,
                (word.empty() ? "A verb is missing" : "'" + word + "' is not a verb") +
                    "; the verbs are " + verbsOf(program) + ".");
}

/// "city plan" as the verb city-plan. Throws if another word follows "city".
std::vector<const char*> withCityVerb(int argc, char** argv) {
    std::vector<const char*> words(argv, argv + argc);
    if (argc < 2 || words[1] != std::string_view("city")) return words;
    const std::string second = argc > 2 ? argv[2] : "";
    for (const char* verb : {"city-plan", "city-run", "city-merge"})
        if ("city-" + second == verb) {
            words.erase(words.begin() + 1);
            words[1] = verb;
            return words;
        }
    throw Error(ExitStatus::usage, "city: '" + second +
                                       "' is not what it does, which is plan, run or "
                                       "merge.");
}

int runVerb(int argc, char** argv) {
    const std::unique_ptr<CLI::App> owned = makeProgram();
    CLI::App& program = *owned;
    const std::vector<const char*> words = withCityVerb(argc, argv);
    requireKnownVerb(program, words);
    try {
        program.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ExtrasError& error) {
        const std::vector<CLI::App*> typed = program.get_subcommands();
        throw Error(ExitStatus::usage,
                    typed.empty() ? error.what() + std::string(".")
                                  : unknownOption(*typed.front(), program.remaining(true), error));
    } catch (const CLI::ParseError& error) {
        const int status = program.exit(error, std::cout, std::cerr);
        return static_cast<int>(status == 0 ? ExitStatus::done : ExitStatus::usage);
    }
    return static_cast<int>(ExitStatus::done);
}

} // namespace

int runProgram(int argc, char** argv) {
    // A file that exceeds the allowed size is an error of writing, and must not kill the process.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return runVerb(argc, argv);
    } catch (const Error& error) {
        return fail(error.what(), error.status());
    } catch (const std::bad_alloc&) {
        return fail("There is not enough memory for this scene.", ExitStatus::unavailable);
    } catch (const std::exception& error) {
        return fail(std::string("Internal error, please report it: ") + error.what(),
                    ExitStatus::unavailable);
    }
}

} // namespace edgeshade::cli
