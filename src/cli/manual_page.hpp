#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgeshade::cli {

/// edgeshade(1) in roff's macros (man(7)): verbs, every option of the table by group, exit
/// statuses. `program`: from makeProgram().
std::string manualPage(const CLI::App& program);

} // namespace edgeshade::cli
