#pragma once

#include "preprocess/base/limits.hpp"

#include <CLI/CLI.hpp>

namespace edgeshade::cli {

/// Adds `--max-file`, `--max-memory`, `--max-triangles`, `--max-nodes` and `--max-node-depth` to a
/// verb; `limits` must outlive parsing.
void addLimitOptions(CLI::App& verb, ReadingLimits& limits);

} // namespace edgeshade::cli
