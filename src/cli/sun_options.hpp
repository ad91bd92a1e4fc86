#pragma once

#include "preprocess/base/error.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/sun/ephemeris.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace edgeshade::cli {

/// `--place`, `--time-of-day` and `--north`.
struct SunOptions {
    std::optional<sun::Place> place;
    std::optional<sun::LocalTime> time; ///< only typed together with a place
    double north = 0.0;                 ///< degrees, see sun::towardsSun()

    bool typed() const { return place && time; }

    // The sun's position; only if typed().
    sun::SunPosition position() const;
    /// The directional light, to be omitted if the sun isn't up.
    Light light() const;
    /// {"place" [latitude, longitude], "time", "north", "azimuth", "altitude", "airless_altitude",
    /// "direction", "up"}, angles in degrees.
    nlohmann::ordered_json json() const;
    /// Whether the sun was typed and isn't up.
    bool isDown() const { return typed() && !position().isUp(); }
    /// "At 2026-06-21T01:00+02:00 the sun at 48.1,11.6 is 17.72 degrees below the horizon".
    std::string downSentence() const;
    /// Throws Error(usage) if the sun was typed and isn't up: without light there is no shadow to
    /// measure.
    void requireUp() const;
};

/// Returns read(); throws its Error as the option's CLI::ValidationError.
template <class Read>
auto readAs(const std::string& option, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

/// `--date`, or `--from` and `--to`, and `--utc-offset`.
struct DayOptions {
    std::optional<std::chrono::sys_days> from, to; ///< both or none
    std::optional<std::chrono::minutes> offset;    ///< of the clock from UTC
};

void addDayOptions(CLI::App& verb, DayOptions& days);

/// Adds `--place`.
CLI::Option* addPlaceOption(CLI::App& verb, std::optional<sun::Place>& place);

/// Adds the options to a verb that has `--sun`, which excludes them; `options` must outlive
/// parsing.
void addSunOptions(CLI::App& verb, SunOptions& options);

} // namespace edgeshade::cli
