#include "src/bench/pareto.hpp"

#include <gtest/gtest.h>

namespace edgeshade::bench {
namespace {

const std::vector<Trade> trades = {
    {10.0, 0.001}, // exact and slow
    {12.0, 0.001}, // as exact, but slower
    {5.0, 1.0},    //
    {5.0, 2.0},    // as fast, but worse
    {2.0, 3.0},    //
    {6.0, 1.5},    // worse in both
};

TEST(Pareto, TheFrontIsWhatNothingBeats) {
    EXPECT_EQ(paretoFront(trades), (std::vector<bool>{true, false, true, false, true, false}));
}

TEST(Pareto, EqualOnesAreBothOnTheFront) {
    EXPECT_EQ(paretoFront(std::vector<Trade>{{1.0, 2.0}, {1.0, 2.0}}),
              (std::vector<bool>{true, true}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(BestWithin, ABudgetTakesTheMostExact) {
    EXPECT_EQ(bestWithin(trades, {20.0, {}}), 0u);
    EXPECT_EQ(bestWithin(trades, {9.0, {}}), 2u);
    EXPECT_EQ(bestWithin(trades, {2.0, {}}), 4u);
    EXPECT_EQ(bestWithin(trades, {1.0, {}}), std::nullopt);
}

TEST(BestWithin, ALimitOnWrongPixelsTakesTheFastest) {
    EXPECT_EQ(bestWithin(trades, {{}, 0.01}), 0u);
    EXPECT_EQ(bestWithin(trades, {{}, 1.9}), 2u);
    EXPECT_EQ(bestWithin(trades, {{}, 100.0}), 4u);
    EXPECT_EQ(bestWithin(trades, {{}, 0.0001}), std::nullopt);
}

TEST(BestWithin, BothLimitsHold) {
    EXPECT_EQ(bestWithin(trades, {6.0, 1.6}), 2u);
    EXPECT_EQ(bestWithin(trades, {4.0, 1.6}), std::nullopt);
}

} // namespace
} // namespace edgeshade::bench
