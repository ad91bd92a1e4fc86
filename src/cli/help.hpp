#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace edgeshade::cli {

/// Gives every verb a --help of at most one screen, with the options that most people need, and a
/// --help-all with every option by group, the laboratory's last.
void setHelp(CLI::App& program);

/// The words of an example after `edgeshade VERB`; empty: `verb` is none.
std::string_view exampleOf(std::string_view verb);

/// A sentence about words that the verb does not accept. For the first option among them it says
/// what replaced it, or which name is the nearest; if none is an option, it repeats `error`.
std::string unknownOption(const CLI::App& verb, const std::vector<std::string>& words,
                          const CLI::ExtrasError& error);

} // namespace edgeshade::cli
