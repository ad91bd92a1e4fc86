#pragma once

#include "tests/support/child_process.hpp"

#include <string>
#include <vector>

namespace edgeshade::test {

/// This project's program, running in a fork of the test's process: to load 72 libraries and a GL
/// for each of a thousand runs takes longer than most of these do.
class EdgeshadeProcess : public ChildProcess {
  public:
    explicit EdgeshadeProcess(const std::vector<std::string>& arguments,
                              const Environment& environment = {});
};

/// Runs the program to its end.
ProcessResult runEdgeshade(const std::vector<std::string>& arguments,
                           const ChildProcess::Environment& environment = {});

} // namespace edgeshade::test
