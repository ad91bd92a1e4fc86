#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgeshade::cli {

/// A bash script that completes verbs, each verb's options, words that options take, and files. It
/// needs no other script. `program`: from makeProgram().
std::string bashCompletion(const CLI::App& program);

} // namespace edgeshade::cli
