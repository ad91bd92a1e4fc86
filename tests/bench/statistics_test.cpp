#include "src/bench/statistics.hpp"

#include <gtest/gtest.h>

namespace edgeshade::bench {

TEST(Statistics, TheMedianIsTheMiddleOrTheMeanOfTheMiddleTwo) {
    EXPECT_EQ(median({}), 0.0);
    EXPECT_EQ(median({3.0}), 3.0);
    EXPECT_EQ(median({9.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median({9.0, 1.0, 2.0, 4.0}), 3.0);
}

TEST(Statistics, APercentileIsOneOfTheValues) {
    std::vector<double> values;
    for (int i = 100; i > 0; --i)
        values.push_back(i);
    EXPECT_EQ(percentile(values, 0.95), 95.0);
    EXPECT_EQ(percentile(values, 1.0), 100.0);
    EXPECT_EQ(percentile(values, 0.001), 1.0);
    EXPECT_EQ(percentile({7.0}, 0.95), 7.0);
    EXPECT_EQ(percentile({1.0, 2.0}, 0.95), 2.0);
}

TEST(Statistics, ASpreadIsMedianP95AndMax) {
    const Spread spread = spreadOf({5.0, 1.0, 3.0});
    EXPECT_EQ(spread.median, 3.0);
    EXPECT_EQ(spread.p95, 5.0);
    EXPECT_EQ(spread.max, 5.0);
}

TEST(Statistics, RatiosArePairedAndNotOfMedians) {
    const std::vector<double> own = {1.0, 10.0, 3.0}, other = {2.0, 5.0, 3.0};
    const Ratios ratios = ratiosOf(own, other);
    EXPECT_EQ(ratios.median, 1.0);
    EXPECT_EQ(ratios.min, 0.5);
    EXPECT_EQ(ratios.max, 2.0);
}

TEST(Statistics, ALineIsFoundAgainAndExplainsAll) {
    const std::vector<double> x = {1.0, 2.0, 4.0, 8.0}, y = {3.5, 4.0, 5.0, 7.0};
    const Line line = fittedLine(x, y);
    EXPECT_NEAR(line.slope, 0.5, 1e-12);
    EXPECT_NEAR(line.offset, 3.0, 1e-12);
    EXPECT_NEAR(line.rSquared, 1.0, 1e-12);
}

TEST(Statistics, WhatIsNoLineIsNotExplainedByOne) {
    const std::vector<double> x = {-1.0, 0.0, 1.0}, y = {1.0, 0.0, 1.0};
    EXPECT_NEAR(fittedLine(x, y).rSquared, 0.0, 1e-12);
}

// A machine that is up to three times slower in some turns, and sometimes disturbs one measurement.
TEST(Statistics, TimesInTurnsAreThoseOfTheQuickestTurn) {
    const std::vector<double> truth = {3.0, 4.0, 5.0};
    int measured = 0;
    const auto times = timesInTurns(3, 7, [&](std::size_t i) {
        const int turn = measured++ / 3;
        const double slow = turn == 4 ? 1.0 : 1.0 + (turn * 5 % 7) / 3.0;
        const bool hit = turn % 3 == static_cast<int>(i) && turn != 4;
        return std::optional(truth[i] * slow * (hit ? 1.02 : 1.0));
    });
    EXPECT_EQ(measured, 3 * 7);
    ASSERT_EQ(times.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(times[i], truth[i], 0.01 * truth[i]);
}

TEST(Statistics, TurnsThatFailAreLeftOut) {
    int measured = 0;
    const auto fails = [&](int turns) {
        measured = 0;
        return timesInTurns(2, turns, [&](std::size_t i) -> std::optional<double> {
            if (measured++ < 3) return std::nullopt;
            return i == 0 ? 1.0 : 2.0;
        });
    };
    EXPECT_EQ(fails(3), (std::vector<double>{1.0, 2.0}));
    EXPECT_TRUE(fails(1).empty());
}

} // namespace edgeshade::bench
