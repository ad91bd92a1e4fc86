#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// Gives every verb a --help of at most one screen, with the options that most people need, and a
/// --help-all of every option by group, the laboratory's last.
void setHelp(CLI::App& program);

/// One sentence about the words that the verb can't take: of the first option among them what
/// became of it, or which name is the nearest; where none is an option, what `error` says.
std::string unknownOption(const CLI::App& verb, const std::vector<std::string>& words,
                          const CLI::ExtrasError& error);

} // namespace edgeshade::cli
