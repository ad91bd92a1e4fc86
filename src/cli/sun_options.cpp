#include "src/cli/sun_options.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/add_options.hpp"
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

CLI::Option* addPlaceOption(CLI::App& verb, std::optional<sun::Place>& place) {
    return addOption(verb, "--place", [&](const std::string& text) {
        const auto at = numbersFrom<2>(text, "--place", "of the form LAT,LON");
        place = readAs("--place", [&] { return sun::placeAt(at[0], at[1]); });
    });
}

void addDayOptions(CLI::App& verb, DayOptions& days) {
    const auto read = [](const std::string& name, const std::string& text) {
        return readAs(name, [&] { return sun::dateFromText(text); });
    };
    CLI::Option* const date = addOption(verb, "--date", [&days, read](const std::string& text) {
        days.from = days.to = read("--date", text);
    });
    CLI::Option* const from = addOption(verb, "--from", [&days, read](const std::string& text) {
        days.from = read("--from", text);
    });
    CLI::Option* const to = addOption(
        verb, "--to", [&days, read](const std::string& text) { days.to = read("--to", text); });
    from->needs(to)->excludes(date);
    to->needs(from)->excludes(date);
    addOption(verb, "--utc-offset", [&days](const std::string& text) {
        days.offset = readAs("--utc-offset", [&] { return sun::offsetFromText(text); });
    });
}

void addSunOptions(CLI::App& verb, SunOptions& options) {
    CLI::Option* const place = addPlaceOption(verb, options.place);
    CLI::Option* const time = addOption(verb, "--time-of-day", [&](const std::string& text) {
        options.time = readAs("--time-of-day", [&] { return sun::localTimeFromText(text); });
    });
    place->needs(time)->excludes(verb.get_option("--sun"));
    time->needs(place);
    addNumber(verb, "--north", options.north)->needs(place);
}

} // namespace edgeshade::cli
