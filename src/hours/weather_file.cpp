#include "src/hours/weather_file.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/file_io.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

/// Number of a field in LOCATION and in a line of data, from 0.
enum LocationField { city = 1, country = 3, latitude = 6, longitude = 7, timeZone = 8 };
enum DataField { month = 1, day = 2, hour = 3, directNormal = 14 };

constexpr std::size_t hoursOfYear = 8760, hoursOfLeapYear = 8784;
/// The value that says that an energy is missing; larger ones say so too.
constexpr double missingEnergy = 9999.0;
constexpr double westmost = -12.0, eastmost = 14.0; ///< hours
/// Days before each month of a leap year.
constexpr std::array<int, 13> daysBefore = {0,   31,  60,  91,  121, 152, 182,
                                            213, 244, 274, 305, 335, 366};
/// Letters of a value that messages quote.
constexpr std::size_t quoted = 40;

/// A line of the file, in fields.
class Line {
  public:
    Line(const std::filesystem::path& path, std::size_t number, std::string_view text)
        : path_(&path), number_(number) {
        for (std::size_t from = 0;;) {
            const std::size_t comma = std::min(text.find(',', from), text.size());
            fields_.push_back(trimmed(text.substr(from, comma - from)));
            if (comma == text.size()) break;
            from = comma + 1;
        }
    }

    std::string_view first() const { return fields_[0]; }
    std::size_t size() const { return fields_.size(); }

    std::string text(std::size_t field, const char* name) const {
        if (field >= fields_.size())
            fail(std::string("has ") + std::to_string(fields_.size()) + " fields, and so no " +
                 name);
        return std::string(fields_[field].substr(0, quoted));
    }
    double number(std::size_t field, const char* name) const {
        const std::string value = text(field, name);
        double number = 0.0;
        const auto read = std::from_chars(value.data(), value.data() + value.size(), number);
        if (read.ec != std::errc() || read.ptr != value.data() + value.size() ||
            !std::isfinite(number))
            fail(std::string(name) + " is '" + value + "', which is not a number");
        return number;
    }
    /// A number from `least` to `most`.
    double numberWithin(std::size_t field, const char* name, double least, double most) const {
        const double value = number(field, name);
        if (value < least || value > most)
            fail(std::string(name) + " is " + text(field, name) + ", but must be from " +
                 std::to_string(std::lround(least)) + " to " + std::to_string(std::lround(most)));
        return value;
    }
    [[noreturn]] void fail(const std::string& about) const {
        throw InputError("'" + path_->string() + "': line " + std::to_string(number_) + ": " +
                         about + ".");
    }

  private:
    static std::string_view trimmed(std::string_view text) {
        while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
            text.remove_prefix(1);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
            text.remove_suffix(1);
        return text;
    }

    const std::filesystem::path* path_;
    std::size_t number_; ///< from 1
    std::vector<std::string_view> fields_;
};

/// The hour of a year that begins a month's day, with or without 29 February.
std::size_t firstHourOf(int monthNumber, int dayNumber, bool leap) {
    const int days = daysBefore[static_cast<std::size_t>(monthNumber - 1)] + dayNumber - 1;
    return 24 * static_cast<std::size_t>(days - (!leap && monthNumber > 2 ? 1 : 0));
}

class Reader {
  public:
    Reader(const std::filesystem::path& path, std::string_view text) : path_(path), rest_(text) {}

    Weather read() {
        readLocation();
        std::optional<Line> line;
        while ((line = next()) && line->first() != "DATA PERIODS") {
        }
        if (!line) fail("has no line of DATA PERIODS");
        if (const std::string perHour = line->text(2, "records an hour"); perHour != "1")
            line->fail("has '" + perHour + "' records an hour, but only files of 1 can be read");
        readHours();
        return weather_;
    }

  private:
    [[noreturn]] void fail(const std::string& about) const {
        throw InputError("'" + path_.string() + "' " + about + ".");
    }

    /// The next line that isn't empty.
    std::optional<Line> next() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
            const std::string_view text = rest_.substr(0, end);
            const bool both = rest_.substr(end, 2) == "\r\n";
            rest_.remove_prefix(std::min(rest_.size(), end + (both ? 2u : 1u)));
            ++number_;
            if (!text.empty()) return Line(path_, number_, text);
        }
        return std::nullopt;
    }

    void readLocation() {
        const std::optional<Line> line = next();
        if (!line || line->first() != "LOCATION")
            fail("is not an EnergyPlus weather file: it doesn't begin with LOCATION");
        weather_.station = line->text(city, "city") + ", " + line->text(country, "country");
        weather_.place = {line->numberWithin(latitude, "latitude", -90.0, 90.0),
                          line->numberWithin(longitude, "longitude", -180.0, 180.0)};
        const double hours = line->numberWithin(timeZone, "time zone", westmost, eastmost);
        weather_.offset = minutes(std::lround(60.0 * hours));
    }

    void readHours() {
        std::vector<std::array<int, 2>> days; // month and day, by hour
        while (const std::optional<Line> line = next()) {
            if (days.size() >= hoursOfLeapYear) line->fail("comes after a whole year of hours");
            const int atMonth = whole(*line, month, "month", 12),
                      atDay = whole(*line, day, "day", daysIn(atMonth)),
                      atHour = whole(*line, hour, "hour", 24);
            const auto wanted = static_cast<int>(days.size() % 24) + 1;
            if (atHour != wanted)
                line->fail("hour is " + std::to_string(atHour) + ", but the line before it makes " +
                           std::to_string(wanted) + " the next");
            days.push_back({atMonth, atDay});
            const double energy = line->number(directNormal, "direct normal radiation");
            if (energy < 0.0)
                line->fail("direct normal radiation is " +
                           line->text(directNormal, "direct normal radiation") +
                           ", but must not be negative");
            const bool missing = energy >= missingEnergy;
            weather_.missing += missing;
            weather_.directNormal.push_back(missing ? 0.0 : energy);
        }
        if (days.size() != hoursOfYear && days.size() != hoursOfLeapYear)
            fail("has " + std::to_string(days.size()) + " hours, but a year has 8760 or 8784");
        requireOrder(days);
    }

    static int daysIn(int atMonth) {
        const auto m = static_cast<std::size_t>(atMonth);
        return daysBefore[m] - daysBefore[m - 1];
    }

    static int whole(const Line& line, std::size_t field, const char* name, int most) {
        const double value = line.numberWithin(field, name, 1.0, most);
        if (value != std::floor(value))
            line.fail(std::string(name) + " is " + line.text(field, name) +
                      ", which is not a whole number");
        return static_cast<int>(value);
    }

    void requireOrder(const std::vector<std::array<int, 2>>& days) const {
        const bool leap = days.size() == hoursOfLeapYear;
        for (std::size_t h = 0; h < days.size(); ++h) {
            const auto [atMonth, atDay] = days[h];
            if ((!leap && atMonth == 2 && atDay == 29) ||
                firstHourOf(atMonth, atDay, leap) != h - h % 24)
                fail("has month " + std::to_string(atMonth) + ", day " + std::to_string(atDay) +
                     " in its " + std::to_string(h + 1) +
                     ". hour, but days must be in order from 1 January on");
        }
    }

    const std::filesystem::path& path_;
    std::string_view rest_;
    std::size_t number_ = 0; ///< of the last line
    Weather weather_;
};

} // namespace

std::size_t Weather::hourOf(sun::Instant instant) const {
    const auto local = instant + offset;
    const auto midnight = floor<days>(local);
    const year_month_day date(midnight);
    const bool leap = directNormal.size() == hoursOfLeapYear;
    const auto atMonth = static_cast<int>(static_cast<unsigned>(date.month()));
    auto atDay = static_cast<int>(static_cast<unsigned>(date.day()));
    if (!leap && atMonth == 2) atDay = std::min(atDay, 28);
    return firstHourOf(atMonth, atDay, leap) +
           static_cast<std::size_t>(floor<std::chrono::hours>(local - midnight).count());
}

Weather readWeather(const std::filesystem::path& path, std::uint64_t mostBytes) {
    const Bytes bytes = readFile(path, mostBytes);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return Reader(path, text).read();
}

} // namespace edgeshade::hours
