#include "tests/support/run_edgeshade.hpp"

#include "src/cli/run_program.hpp"

#include <dlfcn.h>

namespace edgeshade::test {
namespace {

/// Loads what the program loads when it asks for a GL: Mesa, and the LLVM that it draws with.
/// Where they have other names, only time is lost.
bool loadGl() {
    for (const char* const library :
         {"libEGL_mesa.so.0", "/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so"})
        ::dlopen(library, RTLD_NOW | RTLD_LOCAL);
    return true;
}

} // namespace

EdgeshadeProcess::EdgeshadeProcess(const std::vector<std::string>& arguments,
                                   const Environment& environment)
    : ChildProcess([](int argc, char** argv) { return cli::runProgram(argc, argv); }, arguments,
                   environment) {}

ProcessResult runEdgeshade(const std::vector<std::string>& arguments,
                           const ChildProcess::Environment& environment) {
    [[maybe_unused]] static const bool loaded = loadGl();
    return EdgeshadeProcess(arguments, environment).wait();
}

} // namespace edgeshade::test
