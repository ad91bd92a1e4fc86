#include "src/cli/sunhours_options.hpp"

#include "src/cli/add_options.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/report.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace edgeshade::cli {
namespace {

using namespace std::chrono;

/// "9" or "9:30", minutes since 0:00; nothing where it is neither.
std::optional<minutes> clockFrom(std::string_view text) {
    int hour = 0, minute = 0;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, hour);
    if (read.ec != std::errc() || hour < 0 || hour > 24) return std::nullopt;
    if (read.ptr != end) {
        if (*read.ptr != ':' || end - read.ptr != 3) return std::nullopt;
        read = std::from_chars(read.ptr + 1, end, minute);
        if (read.ec != std::errc() || read.ptr != end || minute < 0 || minute > 59)
            return std::nullopt;
    }
    const minutes clock(60 * hour + minute);
    return clock <= days(1) ? std::optional(clock) : std::nullopt;
}

std::string clockText(minutes clock) {
    const auto count = static_cast<int>(clock.count());
    char text[24];
    std::snprintf(text, sizeof text, "%d:%02d", count / 60, count % 60);
    return text;
}

hours::ProbePoint probeFrom(const std::string& text) {
    hours::ProbePoint probe;
    if (std::ranges::count(text, ',') == 2) {
        probe.point = vectorFrom(text, "--at");
        return probe;
    }
    const auto numbers = numbersFrom<6>(text, "--at", "of the form X,Y,Z or X,Y,Z,NX,NY,NZ");
    probe.point = {numbers[0], numbers[1], numbers[2]};
    probe.normal = glm::dvec3(numbers[3], numbers[4], numbers[5]);
    if (*probe.normal == glm::dvec3(0.0))
        throw CLI::ValidationError("--at", "'" + text + "' has the normal 0,0,0");
    return probe;
}

std::pair<std::size_t, std::size_t> partFrom(const std::string& text) {
    std::size_t part = 0, of = 0;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, part);
    bool right = read.ec == std::errc() && read.ptr != end && *read.ptr == '/';
    if (right) {
        read = std::from_chars(read.ptr + 1, end, of);
        right = read.ec == std::errc() && read.ptr == end;
    }
    if (!right || part < 1 || part > of || of > hours::mostPositions)
        throw CLI::ValidationError("--part", "'" + text +
                                                 "' is not of the form K/N with 1 <= K <= N <= " +
                                                 std::to_string(hours::mostPositions));
    return {part, of};
}

void addTimes(CLI::App& verb, SunHoursOptions& options) {
    addDayOptions(verb, options.days);
    addNumber(verb, "--step", options.step);
    addOption(verb, "--hours", [&](const std::string& text) {
        const std::size_t dash = std::min(text.find('-'), text.size() - 1);
        const auto opens = clockFrom(std::string_view(text).substr(0, dash)),
                   closes = clockFrom(std::string_view(text).substr(dash + 1));
        if (!opens || !closes || *opens >= *closes)
            throw CLI::ValidationError("--hours", "'" + text +
                                                      "' is not of the form A-B with clock hours A "
                                                      "before B, both from 0 to 24");
        options.typed.opens = *opens;
        options.typed.closes = *closes;
    });
    addNumber(verb, "--min-altitude", options.minAltitude);
}

void addThresholds(CLI::App& verb, SunHoursOptions& options) {
    CLI::Option* const threshold = addNumber(verb, "--threshold", options.threshold);
    const Values& presets = optionOf(verb.get_name(), "--preset").values;
    addOption(verb, "--preset", [&](const std::string& text) {
        options.preset = &hours::presets()[wordIn(presets, "--preset", text)];
    })->excludes(threshold);
}

} // namespace

std::vector<std::string> SunHoursFiles::all() const {
    std::vector<std::string> paths = {picture};
    paths.insert(paths.end(), more.begin(), more.end());
    return paths;
}

LoadedScene SunHoursOptions::loadForHours(const hours::Schedule& schedule,
                                          std::span<const hours::Position> positions,
                                          bool byRays) const {
    LoadedScene loaded =
        byRays ? loadForRays(Shading::base) : load(Shading::base, ShadowMethod::volumes, false);
    Warnings& warnings = loaded.scene.warnings;
    if (positions.empty())
        warnings.add("The sun is never higher than " +
                     CLI::detail::to_string(schedule.minAltitude) +
                     " degrees in these hours, so there are no hours of sun.");
    if (const std::string about = dateWarning(); !about.empty()) warnings.add(about);
    if (weather && weather->missing > 0)
        warnings.add("'" + epw + "' lacks the direct normal radiation of " +
                     std::to_string(weather->missing) + " hours, which count as 0.");
    printWarnings(warnings.sentences());
    if (!days.offset && !weather)
        printProgress("Clock: UTC" + sun::textOf(schedule.offset) +
                      ", by the longitude; --utc-offset sets another.");
    return loaded;
}

void SunHoursOptions::readWeatherFile() {
    if (!epw.empty()) weather = hours::readWeather(epw, limits.fileBytes);
}

hours::Schedule SunHoursOptions::schedule() const {
    if (!place && !weather)
        throw Error(ExitStatus::usage,
                    "sunhours needs --place, or a weather file of --epw, which has one.");
    hours::Schedule schedule = typed;
    schedule.place = weather ? weather->place : *place;
    schedule.step = minutes(step);
    schedule.minAltitude = minAltitude.value_or(preset ? preset->minAltitude : 0.0);
    schedule.offset = days.offset.value_or(weather ? weather->offset
                                                   : hours::offsetNear(schedule.place.longitude));
    if (days.from) {
        schedule.from = *days.from;
        schedule.to = *days.to;
    } else if (preset) {
        const month_day& day = preset->last;
        schedule.from = schedule.to = hours::presetYear / day.month() / day.day();
    } else {
        throw Error(ExitStatus::usage,
                    "sunhours needs --date, or --from and --to, or a --preset, which has a date.");
    }
    return schedule;
}

std::optional<double> SunHoursOptions::hoursWanted() const {
    return preset ? std::optional(preset->threshold) : threshold;
}

std::optional<double> SunHoursOptions::riseInWindows() const {
    const std::optional<double> rise = preset ? preset->riseInWindow(surface.sill) : std::nullopt;
    if (surface.sill && !rise)
        throw Error(ExitStatus::usage, "--sill needs a --preset of EN 17037; other rules take the "
                                       "middle of a window.");
    return rise;
}

std::string SunHoursOptions::dateWarning() const {
    if (!preset || !days.from) return "";
    const auto fits = [&](sys_days day) {
        const year_month_day ymd(day);
        const month_day at(ymd.month(), ymd.day());
        return preset->first <= at && at <= preset->last;
    };
    const sys_days first = *days.from, last = *days.to;
    if (fits(first) && fits(last) && last - first < std::chrono::days(366)) return "";
    const auto text = [](month_day day) {
        return sun::textOf(sys_days(hours::presetYear / day.month() / day.day())).substr(5);
    };
    return "--preset " + std::string(preset->name) + " is for " +
           (preset->first == preset->last
                ? text(preset->last)
                : "a day from " + text(preset->first) + " to " + text(preset->last)) +
           " (month-day), but the dates are " + sun::textOf(first) + " to " + sun::textOf(last) +
           ".";
}

nlohmann::ordered_json SunHoursOptions::settingsJson(const hours::Schedule& schedule,
                                                     const Scene& scene) const {
    using Json = nlohmann::ordered_json;
    const std::optional<double> wanted = hoursWanted();
    Json settings = {
        {"file", std::filesystem::path(input).filename().string()},
        {"place", {schedule.place.latitude, schedule.place.longitude}},
        {"from", sun::textOf(schedule.from)},
        {"to", sun::textOf(schedule.to)},
        {"step", schedule.step.count()},
        {"hours", clockText(schedule.opens) + "-" + clockText(schedule.closes)},
        {"utc-offset", sun::textOf(schedule.offset)},
        {"utc-offset-typed", days.offset.has_value()},
        {"min-altitude", schedule.minAltitude},
        {"north", schedule.north},
        {"plan", plan},
        {"threshold", wanted ? Json(*wanted) : Json(nullptr)},
        {"preset", preset ? Json(preset->name) : Json(nullptr)},
        {"cast-masked", casters.castMasked},
        {"cast-cutouts", cutoutsCast},
        {"gl-limits", glLimitsName(glLimits)},
    };
    if (weather)
        settings["epw"] = {{"file", std::filesystem::path(epw).filename().string()},
                           {"station", weather->station}};
    if (!variant.empty()) settings["variant"] = variant;
    settings.update(sceneJson(scene));
    return settings;
}

void requireJsonReport(const SunHoursFiles& files) {
    if (files.report.ends_with(".html"))
        throw Error(ExitStatus::usage,
                    "--report: '" + files.report + "', a page, needs --surfaces.");
}

void addSunHoursFileOptions(CLI::App& verb, SunHoursFiles& files) {
    addText(verb, "--counts", files.counts);
    addText(verb, "--report", files.report);
}

void addSunHoursOptions(CLI::App& verb, SunHoursOptions& options) {
    CLI::Option* const place = addPlaceOption(verb, options.place);
    addText(verb, "--epw", options.epw)->excludes(place);
    addTimes(verb, options);
    addNumber(verb, "--north", options.typed.north);
    addThresholds(verb, options);
    addUnlitSceneOptions(verb, options);
    CLI::Option* const plan = verb.add_flag("--plan", options.plan);
    for (const char* other : {"--camera", "--camera-from", "--camera-to", "--camera-matrix",
                              "--ortho", "--fov", "--near"})
        plan->excludes(verb.get_option(other));
    addRepeated(verb, "--at",
                [&](const std::string& text) { options.probes.push_back(probeFrom(text)); });
    addWords(verb, "--by", options.by,
             std::vector{SunHoursBy::automatic, SunHoursBy::rays, SunHoursBy::masks});
    addSunHoursFileOptions(verb, options.files);
    addOption(verb, "--part", [&](const std::string& text) { options.part = partFrom(text); })
        ->excludes(verb.get_option("--counts"))
        ->excludes(verb.get_option("--report"));
    addSurfaceOptions(verb, options.surface);
}

} // namespace edgeshade::cli
