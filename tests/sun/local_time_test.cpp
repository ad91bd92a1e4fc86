#include "preprocess/base/error.hpp"
#include "src/sun/local_time.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using namespace std::chrono;
using sun::localTimeFromText;
using sun::textOf;

std::string refusalOf(const std::string& text) {
    try {
        localTimeFromText(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::usage);
        return error.what();
    }
    return "none";
}

void expectRefused(const std::string& text, const std::string& why) {
    const std::string refusal = refusalOf(text);
    EXPECT_NE(refusal.find(why), std::string::npos) << text << ": " << refusal;
    EXPECT_NE(refusal.find("'" + text + "'"), std::string::npos) << refusal;
}

} // namespace

TEST(LocalTime, IsReadAndWrittenAsTyped) {
    for (const char* text :
         {"2026-06-21T14:30+02:00", "2003-10-17T12:30:30-07:00", "1900-01-01T00:00+00:00",
          "2100-12-31T23:59:59-12:00", "2026-01-01T00:15+14:00", "2026-01-01T12:00+05:45",
          "2024-02-29T12:00+00:00", "2026-01-01T12:00-00:30"})
        EXPECT_EQ(textOf(localTimeFromText(text)), text);
    EXPECT_EQ(textOf(localTimeFromText("2026-06-21T14:30:00Z")), "2026-06-21T14:30+00:00");
}

TEST(LocalTime, OffsetsSayWhatUtcIs) {
    const auto utc = sys_days(2026y / 6 / 21) + 12h + 30min;
    EXPECT_EQ(localTimeFromText("2026-06-21T14:30+02:00").instant, utc);
    EXPECT_EQ(localTimeFromText("2026-06-21T12:30Z").instant, utc);
    EXPECT_EQ(localTimeFromText("2026-06-20T22:30-14:00").instant, utc);
    EXPECT_EQ(localTimeFromText("2026-06-22T02:30+14:00").instant, utc);
}

TEST(LocalTime, TheDayBeginsAtItsClocksMidnight) {
    EXPECT_EQ(sun::startOfDay(localTimeFromText("2026-06-21T00:00+02:00")),
              sys_days(2026y / 6 / 20) + 22h);
    EXPECT_EQ(sun::startOfDay(localTimeFromText("2026-06-21T23:59:59+02:00")),
              sys_days(2026y / 6 / 20) + 22h);
    EXPECT_EQ(sun::startOfDay(localTimeFromText("1969-12-31T20:00-12:00")),
              sys_days(1969y / 12 / 31) + 12h);
}

TEST(LocalTime, LeapDaysAreInLeapYearsAlone) {
    EXPECT_EQ(refusalOf("2024-02-29T12:00Z"), "none");
    EXPECT_EQ(refusalOf("2000-02-29T12:00Z"), "none");
    expectRefused("2023-02-29T12:00Z", "month 2 of 2023 has no day 29");
    expectRefused("1900-02-29T12:00Z", "no day 29");
    expectRefused("2100-02-29T12:00Z", "no day 29");
}

TEST(LocalTime, WhatIsNoTimeIsRefused) {
    for (const char* text :
         {"", "noon", "2026-06-21", "2026-06-21 14:30+02:00", "2026-6-21T14:30+02:00",
          "21.06.2026T14:30+02:00", "2026-06-21T14+02:00", "2026-06-21T14:30+2:00",
          "2026-06-21T14:30+0200", "2026-06-21T14:30+02:00 ", " 2026-06-21T14:30+02:00",
          "2026-06-21T14:30.5+02:00", "2026-06-21T14:30Zulu", "-2026-06-21T14:30Z",
          "2026-06-21T-4:30Z", "2026-06-21T14:30:5Z"})
        expectRefused(text, "not of the form 2026-06-21T14:30+02:00");
    expectRefused("2026-06-21T14:30", "its offset from UTC is missing");
    expectRefused("2026-06-21T14:30:10", "its offset from UTC is missing");
    expectRefused("2026-06-21T14:30+14:01", "more than 14 hours");
    expectRefused("2026-06-21T14:30-23:00", "more than 14 hours");
    expectRefused("2026-06-21T14:30+02:60", "no minute 60");
    expectRefused("2026-06-21T24:00Z", "no hour 24");
    expectRefused("2026-06-21T23:60Z", "no minute 60");
    expectRefused("2016-12-31T23:59:60Z", "no second 60");
    expectRefused("2026-13-01T12:00Z", "no month 13");
    expectRefused("2026-00-01T12:00Z", "no month 0");
    expectRefused("2026-04-31T12:00Z", "month 4 of 2026 has no day 31");
    expectRefused("2026-04-00T12:00Z", "no day 0");
    expectRefused("1899-12-31T12:00Z", "between 1900 and 2100");
    expectRefused("2101-01-01T12:00Z", "between 1900 and 2100");
}

} // namespace edgeshade::test
