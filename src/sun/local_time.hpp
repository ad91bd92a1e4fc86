#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace edgeshade::sun {

/// A point in time, UTC, without leap seconds, as clocks have it.
using Instant = std::chrono::sys_seconds;

// Years that the sun's positions were checked for.
inline constexpr int firstYear = 1900;
inline constexpr int lastYear = 2100;

/// What a clock shows that is `offset` ahead of UTC.
struct LocalTime {
    Instant instant{};
    std::chrono::minutes offset{0}; ///< east of Greenwich is positive

    bool operator==(const LocalTime&) const = default;
};

/// "2026-06-21T14:30+02:00", ISO 8601 in its extended form: seconds may follow the minutes, and the
/// offset from UTC, of at most 14 hours, is a must; Z is +00:00. Throws Error(usage) that says what
/// is wrong with the text, without a full stop: its form, a month, a day that the month doesn't
/// have, an hour, an offset, or a year before firstYear or after lastYear.
LocalTime localTimeFromText(std::string_view text);

/// The other way, with seconds only where there are some.
std::string textOf(const LocalTime& time);

/// "2026-06-21". Throws Error(usage) likewise.
std::chrono::sys_days dateFromText(std::string_view text);
std::string textOf(std::chrono::sys_days date);

/// An offset from UTC, "+02:00" or "Z", of at most 14 hours. Throws Error(usage) likewise.
std::chrono::minutes offsetFromText(std::string_view text);
std::string textOf(std::chrono::minutes offset);

/// When the day of that clock began: 00:00.
Instant startOfDay(const LocalTime& time);

} // namespace edgeshade::sun
