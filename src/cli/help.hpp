#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgeshade::cli {

/// Gives every verb a --help of at most one screen, with the options that most people need, and a
/// --help-all of every option by group, the laboratory's last.
void setHelp(CLI::App& program);

/// One sentence about an option that the verb doesn't have, typed as `word`: what became of it, or
/// which name is the nearest.
std::string unknownOption(const CLI::App& verb, const std::string& word);

} // namespace edgeshade::cli
