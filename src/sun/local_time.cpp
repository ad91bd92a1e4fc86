#include "src/sun/local_time.hpp"

#include "preprocess/base/error.hpp"

#include <array>
#include <cstdio>

namespace edgeshade::sun {
namespace {

using namespace std::chrono;

constexpr int largestOffset = 14 * 60; ///< minutes, the offset of the Line Islands

/// Reads one field after another, and reports the first error.
class FieldReader {
  public:
    /// `thing`: what the text should be; `form`: its form.
    FieldReader(std::string_view text, const char* thing, const char* form)
        : text_(text), rest_(text), thing_(thing), form_(form) {}

    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ExitStatus::usage,
                    "'" + std::string(text_) + "' is not a valid " + thing_ + ": " + why);
    }

    [[noreturn]] void failForm() const { fail(std::string("it is not of the form ") + form_); }

    /// Reads `digits` digits as a number from 0 to `most`.
    int number(int digits, int most, const char* name) {
        int value = 0;
        for (int i = 0; i < digits; ++i) {
            if (rest_.empty() || rest_.front() < '0' || rest_.front() > '9') failForm();
            value = value * 10 + (rest_.front() - '0');
            rest_.remove_prefix(1);
        }
        if (value > most) fail("there is no " + std::string(name) + " " + std::to_string(value));
        return value;
    }

    /// Whether the letter comes next; then skips it.
    bool take(char letter) {
        if (rest_.empty() || rest_.front() != letter) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void require(char letter) {
        if (!take(letter)) failForm();
    }

    bool atEnd() const { return rest_.empty(); }

  private:
    std::string_view text_, rest_;
    const char *thing_, *form_;
};

sys_days dateFrom(FieldReader& reader) {
    const int y = reader.number(4, 9999, "year");
    reader.require('-');
    const auto m = static_cast<unsigned>(reader.number(2, 99, "month"));
    reader.require('-');
    const auto d = static_cast<unsigned>(reader.number(2, 99, "day"));
    if (y < firstYear || y > lastYear)
        reader.fail("its year is not between " + std::to_string(firstYear) + " and " +
                    std::to_string(lastYear));
    if (!month(m).ok()) reader.fail("there is no month " + std::to_string(m));
    const year_month_day date = year(y) / month(m) / day(d);
    if (!date.ok())
        reader.fail("month " + std::to_string(m) + " of " + std::to_string(y) + " has no day " +
                    std::to_string(d));
    return sys_days(date);
}

minutes offsetFrom(FieldReader& reader) {
    if (reader.take('Z')) return minutes(0);
    const bool west = reader.take('-');
    if (!west && !reader.take('+')) {
        if (reader.atEnd()) reader.fail("its offset from UTC is missing, such as +02:00 or Z");
        reader.failForm();
    }
    int offset = reader.number(2, 99, "hour") * 60;
    reader.require(':');
    offset += reader.number(2, 59, "minute");
    if (offset > largestOffset) reader.fail("its offset from UTC is more than 14 hours");
    return minutes(west ? -offset : offset);
}

} // namespace

LocalTime localTimeFromText(std::string_view text) {
    FieldReader reader(text, "time",
                       "2026-06-21T14:30+02:00, seconds behind the minutes allowed, Z for +00:00");
    sys_seconds shown = dateFrom(reader);
    reader.require('T');
    shown += hours(reader.number(2, 23, "hour"));
    reader.require(':');
    shown += minutes(reader.number(2, 59, "minute"));
    if (reader.take(':')) shown += seconds(reader.number(2, 59, "second"));
    const minutes offset = offsetFrom(reader);
    if (!reader.atEnd()) reader.failForm();
    return {shown - offset, offset};
}

std::string textOf(const LocalTime& time) {
    const sys_seconds shown = time.instant + time.offset;
    const sys_days date = floor<days>(shown);
    const hh_mm_ss clock(shown - date);
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "T%02d:%02d", static_cast<int>(clock.hours().count()),
                  static_cast<int>(clock.minutes().count()));
    std::string all = textOf(date) + text.data();
    if (clock.seconds().count() != 0) {
        std::snprintf(text.data(), text.size(), ":%02d", static_cast<int>(clock.seconds().count()));
        all += text.data();
    }
    return all + textOf(time.offset);
}

sys_days dateFromText(std::string_view text) {
    FieldReader reader(text, "date", "2026-06-21");
    const sys_days date = dateFrom(reader);
    if (!reader.atEnd()) reader.failForm();
    return date;
}

std::string textOf(sys_days date) {
    const year_month_day ymd(date);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(ymd.year()),
                  static_cast<unsigned>(ymd.month()), static_cast<unsigned>(ymd.day()));
    return text.data();
}

minutes offsetFromText(std::string_view text) {
    FieldReader reader(text, "offset from UTC", "+02:00, or Z");
    const minutes offset = offsetFrom(reader);
    if (!reader.atEnd()) reader.failForm();
    return offset;
}

std::string textOf(minutes offset) {
    const auto size = static_cast<int>(abs(offset).count());
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%c%02d:%02d", offset < minutes(0) ? '-' : '+',
                  size / 60, size % 60);
    return text.data();
}

Instant startOfDay(const LocalTime& time) {
    return floor<days>(time.instant + time.offset) - time.offset;
}

} // namespace edgeshade::sun
