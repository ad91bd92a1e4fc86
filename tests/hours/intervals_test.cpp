#include "src/hours/intervals.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

std::vector<sun::Instant> everyHour(sun::Instant from, int count) {
    std::vector<sun::Instant> times;
    for (int i = 0; i < count; ++i)
        times.push_back(from + std::chrono::hours(i) + minutes(30));
    return times;
}

const sun::Instant midnight = sys_days(2026y / March / 21);

} // namespace

TEST(LitIntervals, JoinWhatTouches) {
    const auto found = litIntervals(everyHour(midnight, 6), {true, true, false, true, true, false},
                                    minutes(60), minutes(0));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], Interval(midnight, midnight + minutes(120)));
    EXPECT_EQ(found[1], Interval(midnight + minutes(180), midnight + minutes(300)));
}

TEST(LitIntervals, EndWithTheClocksDay) {
    const auto times = everyHour(midnight + minutes(22 * 60), 4); // polar day
    EXPECT_EQ(litIntervals(times, {true, true, true, true}, minutes(60), minutes(0)).size(), 2u);
    EXPECT_EQ(litIntervals(times, {true, true, true, true}, minutes(60), minutes(-240)).size(), 1u);
}

TEST(LitIntervals, KeepGapsBetweenPositionsApart) {
    std::vector<sun::Instant> times = everyHour(midnight, 4);
    times.erase(times.begin() + 1);
    EXPECT_EQ(litIntervals(times, {true, true, true}, minutes(60), minutes(0)).size(), 2u);
}

TEST(LitIntervals, AreNoneInTheDark) {
    EXPECT_TRUE(
        litIntervals(everyHour(midnight, 2), {false, false}, minutes(60), minutes(0)).empty());
}

} // namespace edgeshade::hours
