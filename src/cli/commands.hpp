#pragma once

#include <CLI/CLI.hpp>

namespace edgeshade::cli {

// Each function adds a verb with its options; parsing the command line runs it. Verbs throw Error.
void addPackCommand(CLI::App& program);
void addInfoCommand(CLI::App& program);
void addRenderCommand(CLI::App& program);
void addCompareCommand(CLI::App& program);
void addBenchCommand(CLI::App& program);
void addTradeoffCommand(CLI::App& program);
void addSunHoursCommand(CLI::App& program);
void addSunHoursMergeCommand(CLI::App& program);
void addCityPlanCommand(CLI::App& program);
void addCityRunCommand(CLI::App& program);
void addCityMergeCommand(CLI::App& program);
void addViewCommand(CLI::App& program);

} // namespace edgeshade::cli
