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

TEST(Statistics, LeastTimesWaitForTheDisturbanceToEnd) {
    int turn = 0;
    const auto least = leastTimes(3, 4, [&](std::size_t i) -> std::optional<double> {
        turn += i == 0;
        if (i == 1) return std::nullopt;
        const double disturbance = turn < 9 ? 30.0 - turn : 0.0;
        return 10.0 + disturbance + 0.01 * (turn % 3);
    });
    EXPECT_EQ(turn, 13) << "quiet from the ninth on";
    EXPECT_EQ(least[0], 10.0);
    EXPECT_FALSE(least[1]);
    EXPECT_EQ(least[2], 10.0);
}

TEST(Statistics, LeastTimesEndWhereTheyNeverSettle) {
    double time = 1e6;
    int measured = 0;
    leastTimes(2, 3, [&](std::size_t) {
        ++measured;
        return std::optional(time *= 0.9);
    });
    EXPECT_EQ(measured, 2 * 30);
}

} // namespace edgeshade::bench
