#include "src/cli/sun_options.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/number_text.hpp"
#include "src/sun/direction.hpp"

#include <cstdio>

namespace edgeshade::cli {

sun::SunPosition SunOptions::position() const {
    return sun::sunPosition(*place, time->instant);
}

Light SunOptions::light() const {
    Light light;
    light.position = glm::dvec4(sun::towardsSun(position(), north), 0.0);
    return light;
}

nlohmann::ordered_json SunOptions::json() const {
    const sun::SunPosition at = position();
    const glm::dvec3 towards = sun::towardsSun(at, north);
    return {{"place", {place->latitude, place->longitude}},
            {"time", sun::textOf(*time)},
            {"north", north},
            {"azimuth", at.azimuth},
            {"altitude", at.altitude},
            {"airless_altitude", at.airlessAltitude},
            {"direction", {towards.x, towards.y, towards.z}},
            {"up", at.isUp()}};
}

std::string SunOptions::downSentence() const {
    char text[160];
    std::snprintf(text, sizeof text, "At %s the sun at %.6g,%.6g is %.2f degrees below the horizon",
                  sun::textOf(*time).c_str(), place->latitude, place->longitude,
                  -position().altitude);
    return text;
}

void SunOptions::requireUp() const {
    if (isDown())
        throw Error(ExitStatus::usage, "--time-of-day: " + downSentence() +
                                           ", so there is no shadow of it to measure.");
}

CLI::Option* addPlaceOption(CLI::App& verb, std::optional<sun::Place>& place,
                            const std::string& help) {
    return verb
        .add_option_function<std::string>(
            "--place",
            [&](const std::string& text) {
                const auto at = numbersFrom<2>(text, "--place", "of the form LAT,LON");
                place = readAs("--place", [&] { return sun::placeAt(at[0], at[1]); });
            },
            help)
        ->type_name("LAT,LON");
}

CLI::Option* addNorthOption(CLI::App& verb, double& north) {
    return verb
        .add_option_function<std::string>(
            "--north",
            [&](const std::string& text) {
                north = numberFrom(text, "--north");
                if (std::abs(north) > 360.0)
                    throw CLI::ValidationError("--north",
                                               "'" + text + "' is not between -360 and 360");
            },
            "Where the scene's north is: degrees clockwise from -Z, seen from above (0: -Z is "
            "north, +X east)")
        ->type_name("DEG");
}

void addSunOptions(CLI::App& verb, SunOptions& options) {
    CLI::Option* const place =
        addPlaceOption(verb, options.place,
                       "A sun as it stands over this place at --time-of-day: degrees north and "
                       "east, those south and west negative. It is a light like --sun, the first "
                       "one; where it is below the horizon it is left out");
    CLI::Option* const time =
        verb.add_option_function<std::string>(
                "--time-of-day",
                [&](const std::string& text) {
                    options.time =
                        readAs("--time-of-day", [&] { return sun::localTimeFromText(text); });
                },
                "When that is, of the years 1900 to 2100, with the clock's offset from UTC, e.g. "
                "2026-06-21T14:30+02:00")
            ->type_name("TIME");
    place->needs(time)->excludes(verb.get_option("--sun"));
    time->needs(place);
    addNorthOption(verb, options.north)->needs(place);
}

} // namespace edgeshade::cli
