#include "preprocess/error.hpp"
#include "src/cli/commands.hpp"

#include <iostream>
#include <new>

namespace {

using edgeshade::ExitStatus;

int fail(const std::string& sentence, ExitStatus status) {
    std::cerr << "edgeshade: " << sentence << std::endl;
    return static_cast<int>(status);
}

int run(int argc, char** argv) {
    CLI::App program("Pixel-exact hard shadows for glTF scenes.\n"
                     "Exit status: 0 done; 1 wrong usage; 2 input unreadable or invalid; 3 not "
                     "possible here; 4 output can't be written.",
                     "edgeshade");
    program.set_version_flag("--version", std::string("edgeshade ") + EDGESHADE_VERSION);
    program.require_subcommand(1);
    edgeshade::cli::addPackCommand(program);
    edgeshade::cli::addInfoCommand(program);
    edgeshade::cli::addRenderCommand(program);
    edgeshade::cli::addCompareCommand(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int status = program.exit(error, std::cout, std::cerr);
        return static_cast<int>(status == 0 ? ExitStatus::done : ExitStatus::usage);
    }
    return static_cast<int>(ExitStatus::done);
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const edgeshade::Error& error) {
        return fail(error.what(), error.status());
    } catch (const std::bad_alloc&) {
        return fail("There is not enough memory for this scene.", ExitStatus::unavailable);
    } catch (const std::exception& error) {
        return fail(std::string("This is a fault of the program, please report it: ") +
                        error.what(),
                    ExitStatus::unavailable);
    }
}
