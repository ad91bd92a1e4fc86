#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace edgeshade::sun {

/// A point in time, UTC without leap seconds, as clocks show it.
using Instant = std::chrono::sys_seconds;

// Years for which the sun's positions were checked.
inline constexpr int firstYear = 1900;
inline constexpr int lastYear = 2100;

/// The time on a clock that is `offset` ahead of UTC.
struct LocalTime {
    Instant instant{};
    std::chrono::minutes offset{0}; ///< positive east of Greenwich

    bool operator==(const LocalTime&) const = default;
};

/// Parses "2026-06-21T14:30+02:00", ISO 8601 in its extended form. Seconds may follow the minutes.
/// The offset from UTC, of at most 14 hours, is required; Z is +00:00. Throws Error(usage) that
/// names the error in the text, without a full stop: its form, a month, a day that the month lacks,
/// an hour, an offset, or a year before firstYear or after lastYear.
LocalTime localTimeFromText(std::string_view text);

/// The text of a time, with seconds only if they aren't 0.
std::string textOf(const LocalTime& time);

/// Parses "2026-06-21". Throws Error(usage) like localTimeFromText().
std::chrono::sys_days dateFromText(std::string_view text);
std::string textOf(std::chrono::sys_days date);

/// Parses an offset from UTC, "+02:00" or "Z", of at most 14 hours. Throws Error(usage) like
/// localTimeFromText().
std::chrono::minutes offsetFromText(std::string_view text);
std::string textOf(std::chrono::minutes offset);

/// The start of the day, 00:00, on that clock.
Instant startOfDay(const LocalTime& time);

} // namespace edgeshade::sun
