#include "tests/support/run_edgeshade.hpp"

#include "src/cli/run_program.hpp"
#include "tests/support/kept_gl.hpp"

namespace edgeshade::test {

EdgeshadeProcess::EdgeshadeProcess(const std::vector<std::string>& arguments,
                                   const Environment& environment)
    : ChildProcess(cli::runProgram, arguments, environment) {}

ProcessResult runEdgeshade(const std::vector<std::string>& arguments,
                           const ChildProcess::Environment& environment) {
    keepGlLoaded();
    return EdgeshadeProcess(arguments, environment).wait();
}

} // namespace edgeshade::test
