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
    std::optional<sun::LocalTime> time; ///< typed with a place, and never without
    double north = 0.0;                 ///< degrees, see sun::towardsSun()

    bool typed() const { return place && time; }

    // Of a sun that was typed.
    sun::SunPosition position() const;
    /// The directional light, which is to be left out where the sun isn't up.
    Light light() const;
    /// {"place" [latitude, longitude], "time", "north", "azimuth", "altitude", "airless_altitude",
    /// "direction", "up"}, angles in degrees.
    nlohmann::ordered_json json() const;
    /// Whether it was typed and isn't up.
    bool isDown() const { return typed() && !position().isUp(); }
    /// "At 2026-06-21T01:00+02:00 the sun at 48.1,11.6 is 17.72 degrees below the horizon".
    std::string downSentence() const;
    /// Throws Error(usage) where it was typed and isn't up: without light no shadow is there to be
    /// measured.
    void requireUp() const;
};

/// What `read` makes of an option's text; its Error as CLI::ValidationError of the option.
template <class Read>
auto readAs(const std::string& option, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

/// Adds `--place`.
CLI::Option* addPlaceOption(CLI::App& verb, std::optional<sun::Place>& place);

/// Adds the options to a verb that has `--sun`, with which they don't go; `options` must outlive
/// parsing.
void addSunOptions(CLI::App& verb, SunOptions& options);

} // namespace edgeshade::cli
