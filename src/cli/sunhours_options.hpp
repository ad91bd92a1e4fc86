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

/// The output files for hours of sunlight.
struct SunHoursFiles {
    std::string picture; ///< .png
    std::string counts;  ///< .png; empty: none
    std::string report;  ///< empty: none
};

/// Values of `--by`.
enum class SunHoursBy { automatic, rays, masks };

/// Options of `sunhours`, as typed.
struct SunHoursOptions : SceneOptions {
    SunHoursFiles files; ///< for a part, `picture` is the part's file
    std::optional<sun::Place> place;
    std::optional<std::chrono::sys_days> date, from, to;
    std::optional<std::chrono::minutes> offset;
    int step{};            ///< minutes that each sun position stands for
    hours::Schedule typed; ///< its hours, least altitude and north
    bool plan = false;
    SunHoursBy by = SunHoursBy::automatic;
    std::optional<double> threshold; ///< hours per day
    const hours::Preset* preset = nullptr;
    std::vector<hours::ProbePoint> probes;
    std::optional<std::pair<std::size_t, std::size_t>> part; ///< K of N

    /// Throws Error(usage) if no date was typed, and for options that don't go together.
    hours::Schedule schedule() const;
    std::optional<double> hoursWanted() const;
    /// Warning if --preset does not suit the dates; empty: none.
    std::string dateWarning() const;
    /// The settings that reports and merging need. `schedule`: from schedule(). `scene`: as loaded.
    nlohmann::ordered_json settingsJson(const hours::Schedule& schedule, const Scene& scene) const;
};

/// `--counts` and `--report`.
void addSunHoursFileOptions(CLI::App& verb, SunHoursFiles& files);

/// Adds the options to the verb; `options` must outlive parsing.
void addSunHoursOptions(CLI::App& verb, SunHoursOptions& options);

} // namespace edgeshade::cli
