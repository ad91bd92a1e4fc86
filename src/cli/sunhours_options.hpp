#pragma once

#include "src/cli/options.hpp"
#include "src/hours/part.hpp"
#include "src/hours/preset.hpp"
#include "src/hours/schedule.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeshade::cli {

/// The files that hours of sun become.
struct SunHoursFiles {
    std::string picture; ///< .png
    std::string counts;  ///< .png; empty: none
    std::string report;  ///< empty: none
};

/// `sunhours`, as typed.
struct SunHoursOptions : SceneOptions {
    SunHoursFiles files; ///< of a part, `picture` is the part's file
    std::optional<sun::Place> place;
    std::optional<std::chrono::sys_days> date, from, to;
    std::optional<std::chrono::minutes> offset;
    int step{};            ///< minutes that each sun position stands for
    hours::Schedule typed; ///< its hours, least altitude and north
    bool plan = false;
    std::optional<double> threshold; ///< hours a day
    const hours::Preset* preset = nullptr;
    std::vector<hours::ProbePoint> probes;
    std::optional<std::pair<std::size_t, std::size_t>> part; ///< K of N

    /// Throws Error(usage) where no date was typed, and for what does not go together.
    hours::Schedule schedule() const;
    std::optional<double> hoursWanted() const;
    /// What --preset has against the days; empty: nothing.
    std::string dateWarning() const;
    /// All that reports and merging need of it. `schedule`: its own. `scene`: as it was loaded.
    nlohmann::ordered_json settingsJson(const hours::Schedule& schedule, const Scene& scene) const;
};

/// `--counts` and `--report`.
void addSunHoursFileOptions(CLI::App& verb, SunHoursFiles& files);

/// Adds the options to the verb; `options` must outlive parsing.
void addSunHoursOptions(CLI::App& verb, SunHoursOptions& options);

} // namespace edgeshade::cli
