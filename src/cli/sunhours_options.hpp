#pragma once

#include "src/cli/options.hpp"
#include "src/cli/surface_options.hpp"
#include "src/hours/part.hpp"
#include "src/hours/preset.hpp"
#include "src/hours/schedule.hpp"
#include "src/hours/weather_file.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeshade::cli {

/// The output files for hours of sunlight.
struct SunHoursFiles {
    std::string picture;           ///< .png; with --surfaces the first of the files
    std::string counts;            ///< .png; empty: none
    std::string report;            ///< empty: none
    std::vector<std::string> more; ///< with --surfaces: the files after the first

    /// The first file and those after it.
    std::vector<std::string> all() const;
};

/// Values of `--by`.
enum class SunHoursBy { automatic, rays, masks };

/// Options of `sunhours`, as typed.
struct SunHoursOptions : SceneOptions {
    SunHoursFiles files; ///< for a part, `picture` is the part's file
    std::optional<sun::Place> place;
    DayOptions days;
    int step{};                        ///< minutes that each sun position stands for
    hours::Schedule typed;             ///< its hours and north
    std::optional<double> minAltitude; ///< degrees; null: the preset's, or 0
    bool plan = false;
    SunHoursBy by = SunHoursBy::automatic;
    std::optional<double> threshold; ///< hours per day
    const hours::Preset* preset = nullptr;
    std::vector<hours::ProbePoint> probes;
    SurfaceOptions surface;
    std::string epw;                       ///< the weather file; empty: none
    std::optional<hours::Weather> weather; ///< from that file, after readWeatherFile()
    std::optional<std::pair<std::size_t, std::size_t>> part; ///< K of N

    /// Reads the weather file, if one was typed. Throws InputError.
    void readWeatherFile();
    /// Throws Error(usage) if neither place nor weather file, or no date, was typed, and for
    /// options that don't go together.
    hours::Schedule schedule() const;
    std::optional<double> hoursWanted() const;
    /// Metres of windows' sensors over their lower edges; null: in the middle. Throws Error(usage)
    /// for a sill that no preset uses.
    std::optional<double> riseInWindows() const;
    /// Warning if --preset does not suit the dates; empty: none.
    std::string dateWarning() const;
    /// Loads the scene, and prints its warnings and those about dates and clock. `positions`: those
    /// of the schedule; `byRays`: as for loadForRays().
    LoadedScene loadForHours(const hours::Schedule& schedule,
                             std::span<const hours::Position> positions, bool byRays) const;
    /// The settings that reports and merging need. `schedule`: from schedule(). `scene`: as loaded.
    nlohmann::ordered_json settingsJson(const hours::Schedule& schedule, const Scene& scene) const;
};

/// Throws Error(usage) for a report that is a page, which only --surfaces makes.
void requireJsonReport(const SunHoursFiles& files);

/// `--counts` and `--report`.
void addSunHoursFileOptions(CLI::App& verb, SunHoursFiles& files);

/// Adds the options to the verb; `options` must outlive parsing.
void addSunHoursOptions(CLI::App& verb, SunHoursOptions& options);

} // namespace edgeshade::cli
