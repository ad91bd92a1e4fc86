#include "preprocess/base/error.hpp"
#include "src/cli/help.hpp"
#include "src/cli/program.hpp"

#include <csignal>
#include <iostream>
#include <new>

namespace {

using edgeshade::ExitStatus;

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
void requireKnownVerb(const CLI::App& program, int argc, char** argv) {
    const std::string word = argc > 1 ? argv[1] : "";
    if (word.starts_with('-')) return;
    for (const CLI::App* verb : program.get_subcommands(nullptr))
        if (verb->get_name() == word) return;
    throw edgeshade::Error(ExitStatus::usage,
                           (word.empty() ? "A verb is missing" : "'" + word + "' is not a verb") +
                               "; the verbs are " + verbsOf(program) + ".");
}

int run(int argc, char** argv) {
    const std::unique_ptr<CLI::App> owned = edgeshade::cli::makeProgram();
    CLI::App& program = *owned;
    requireKnownVerb(program, argc, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ExtrasError& error) {
        const std::vector<CLI::App*> typed = program.get_subcommands();
        throw edgeshade::Error(ExitStatus::usage,
                               typed.empty() ? error.what() + std::string(".")
                                             : edgeshade::cli::unknownOption(
                                                   *typed.front(), program.remaining(true), error));
    } catch (const CLI::ParseError& error) {
        const int status = program.exit(error, std::cout, std::cerr);
        return static_cast<int>(status == 0 ? ExitStatus::done : ExitStatus::usage);
    }
    return static_cast<int>(ExitStatus::done);
}

} // namespace

int main(int argc, char** argv) {
    // A file that exceeds the allowed size is an error of writing, and must not kill the process.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const edgeshade::Error& error) {
        return fail(error.what(), error.status());
    } catch (const std::bad_alloc&) {
        return fail("There is not enough memory for this scene.", ExitStatus::unavailable);
    } catch (const std::exception& error) {
        return fail(std::string("Internal error, please report it: ") + error.what(),
                    ExitStatus::unavailable);
    }
}
