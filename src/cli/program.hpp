#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string_view>

namespace edgeshade::cli {

/// An exit status and its meaning, a clause.
struct StatusMeaning {
    int status;
    std::string_view meaning;
};
inline constexpr StatusMeaning statusMeanings[] = {{0, "done"},
                                                   {1, "wrong usage"},
                                                   {2, "input unreadable or invalid"},
                                                   {3, "not possible here"},
                                                   {4, "output can't be written"}};

/// The parser of the whole command line: --version, every verb with its options, help. Parsing
/// runs the verb, which throws Error.
std::unique_ptr<CLI::App> makeProgram();

} // namespace edgeshade::cli
