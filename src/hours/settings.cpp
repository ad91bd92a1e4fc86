#include "src/hours/settings.hpp"

#include "src/sun/local_time.hpp"

namespace edgeshade::hours {
namespace {

constexpr std::uint64_t longestStep = 24 * 60; ///< minutes
constexpr double mostHours = 24.0;

std::chrono::sys_days dateOf(const JsonField& field) {
    return readAs(field, sun::dateFromText);
}

} // namespace

HoursSettings hoursSettings(const JsonField& settings) {
    HoursSettings read;
    read.file = settings.member("file").text();
    const JsonField last = settings.member("to");
    const std::chrono::sys_days from = dateOf(settings.member("from")), to = dateOf(last);
    if (to < from) last.fail(" is before the first date");
    read.from = sun::textOf(from);
    read.to = sun::textOf(to);
    read.days = static_cast<std::size_t>((to - from).count()) + 1;
    const JsonField step = settings.member("step");
    const std::uint64_t minutes = step.wholeNumber(longestStep);
    if (minutes == 0) step.fail(" is 0, but must be at least 1");
    read.step = std::chrono::minutes(minutes);
    read.offset = readAs(settings.member("utc-offset"), sun::offsetFromText);
    const std::vector<double> place = settings.member("place").numbers(2);
    read.latitude = place[0];
    read.longitude = place[1];
    settings.ifPresent("threshold", [&](const JsonField& field) {
        if (field.value().is_null()) return;
        read.threshold = field.notNegative();
        if (*read.threshold > mostHours) field.fail(" is more than 24 hours a day");
    });
    settings.ifPresent("preset", [&](const JsonField& field) {
        if (field.value().is_null()) return;
        read.preset = findPreset(field.text());
        if (!read.preset) field.fail(" is '" + field.text() + "', which is not a preset");
    });
    return read;
}

} // namespace edgeshade::hours
