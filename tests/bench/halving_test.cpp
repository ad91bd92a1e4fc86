#include "src/bench/halving.hpp"

#include "src/bench/confidence.hpp"
#include "src/bench/pareto.hpp"
#include "src/bench/statistics.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace edgeshade::bench {
namespace {

/// Settings with made-up costs and errors. Each has a typical time and a typical error; single
/// frames and views are more or less costly for all of them, and both have noise.
class MadeUp : public Measurer {
  public:
    struct Setting {
        double ms = 10.0;
        double wrong = 100.0; ///< typical number of wrong pixels in a view
        int alike = -1;       ///< has the same errors as that setting in every view
    };

    MadeUp(std::vector<Setting> settings, double noise, unsigned seed)
        : settings_(std::move(settings)), noise_(noise), seed_(seed) {}

    double secondsOfPreparing = 0.0, secondsOfFrame = 0.0, secondsOfView = 0.0; ///< per setting
    std::size_t framesDrawn = 0, viewsJudged = 0;
    std::vector<int> frameOrder;

    double clock() override { return clock_; }
    void prepareFrames(std::span<const std::size_t> who) override { prepareAny(who); }
    void prepareViews(std::span<const std::size_t> who) override { prepareAny(who); }
    std::vector<double> frame(int index, std::span<const std::size_t> who) override {
        std::vector<double> times;
        for (const std::size_t i : who)
            times.push_back(frameMs(index, i));
        clock_ += secondsOfFrame * static_cast<double>(who.size());
        framesDrawn += who.size();
        frameOrder.push_back(index);
        return times;
    }
    std::vector<ViewErrors> view(int index, std::span<const std::size_t> who) override {
        std::vector<ViewErrors> errors;
        for (const std::size_t i : who)
            errors.push_back(errorsIn(index, i));
        clock_ += secondsOfView * static_cast<double>(who.size());
        viewsJudged += who.size();
        return errors;
    }
    void progress(double share, const std::string&) override {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
    }

    /// The Pareto front of all settings when everything is measured in full.
    std::vector<bool> frontInFull(const Effort& effort) const {
        std::vector<Trade> trades;
        for (std::size_t i = 0; i < settings_.size(); ++i) {
            std::vector<double> times;
            for (int f = 0; f < effort.frames; ++f)
                times.push_back(frameMs(f, i));
            double wrong = 0.0;
            for (int v = 0; v < effort.views; ++v)
                wrong += static_cast<double>(errorsIn(v, i).wrong);
            trades.push_back({median(times), wrong});
        }
        return paretoFront(trades);
    }

  private:
    double normal(int kind, int index, std::size_t setting) const {
        std::seed_seq seed{seed_, static_cast<unsigned>(kind), static_cast<unsigned>(index),
                           static_cast<unsigned>(setting)};
        std::mt19937 random(seed);
        return std::normal_distribution<double>()(random);
    }
    double frameMs(int index, std::size_t i) const {
        const double place = 0.4 * normal(0, index, 1000);
        return settings_[i].ms * std::exp(place + noise_ * normal(1, index, i));
    }
    ViewErrors errorsIn(int index, std::size_t i) const {
        if (settings_[i].alike >= 0) i = static_cast<std::size_t>(settings_[i].alike);
        const double place = normal(2, index, 1000), own = 0.7 * normal(3, index, i);
        const double wrong = settings_[i].wrong * std::exp(place + own);
        return {static_cast<std::size_t>(wrong), 0, 100000};
    }
    void prepareAny(std::span<const std::size_t> who) {
        clock_ += secondsOfPreparing * static_cast<double>(who.size());
    }

    std::vector<Setting> settings_;
    double noise_;
    unsigned seed_;
    double clock_ = 0.0;
};

/// As many settings as tradeoff has, of all speeds and errors; some draw the same as others.
std::vector<MadeUp::Setting> drawnSettings(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit;
    std::vector<MadeUp::Setting> settings;
    for (int i = 0; i < 40; ++i) {
        MadeUp::Setting one{std::exp(3.0 * unit(random)), std::exp(9.0 * unit(random)), -1};
        if (i > 0 && unit(random) < 0.2) {
            one.alike = static_cast<int>(unit(random) * i);
            while (settings[static_cast<std::size_t>(one.alike)].alike >= 0)
                one.alike = settings[static_cast<std::size_t>(one.alike)].alike;
        }
        settings.push_back(one);
    }
    return settings;
}

// With 600 seeds and 24,000 settings, two settings are dropped that full measuring just puts on the
// front.
TEST(Halving, DropsNothingThatFullMeasuringPutsOnTheFront) {
    std::size_t dropped = 0, beaten = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const double noise = seed % 3 == 0 ? 0.02 : seed % 3 == 1 ? 0.1 : 0.3;
        MadeUp measurer(drawnSettings(seed), noise, seed);
        const Effort effort;
        const auto standings = halve(40, effort, measurer);
        const auto front = measurer.frontInFull(effort);
        for (std::size_t i = 0; i < standings.size(); ++i) {
            dropped += standings[i].dominator.has_value();
            beaten += !front[i];
            EXPECT_FALSE(front[i] && standings[i].dominator)
                << "seed " << seed << ", setting " << i << " by " << *standings[i].dominator;
        }
    }
    EXPECT_GT(dropped, beaten / 3);
}

TEST(Halving, WhatIsFarWorseIsDroppedEarlyAndMeasuredLess) {
    MadeUp measurer({{10.0, 10.0, -1}, {30.0, 1000.0, -1}, {5.0, 3000.0, -1}, {25.0, 10.0, 0}},
                    0.05, 1);
    const auto standings = halve(4, {}, measurer);
    EXPECT_FALSE(standings[0].dominator);
    EXPECT_EQ(standings[1].dominator, 0u);
    EXPECT_FALSE(standings[2].dominator);
    EXPECT_EQ(standings[3].dominator, 0u); // draws the same, takes longer
    EXPECT_EQ(standings[0].evidence.frameMs.size(), 40u);
    EXPECT_EQ(standings[0].evidence.views.size(), 16u);
    EXPECT_EQ(standings[1].evidence.frameMs.size(), 10u);
    EXPECT_LE(standings[1].evidence.views.size(), 8u);
    EXPECT_LT(standings[1].rounds, standings[0].rounds);
}

TEST(Halving, FramesAreThoseOfTheFlightEachOnce) {
    for (const int frames : {1, 2, 7, 40, 41}) {
        MadeUp measurer({{}, {}}, 0.1, 2);
        halve(2, {frames, 1}, measurer);
        std::sort(measurer.frameOrder.begin(), measurer.frameOrder.end());
        ASSERT_EQ(measurer.frameOrder.size(), static_cast<std::size_t>(frames));
        for (int i = 0; i < frames; ++i)
            EXPECT_EQ(measurer.frameOrder[static_cast<std::size_t>(i)], i);
    }
}

TEST(Halving, KeepsWithinTheTimeAndMeasuresAllAlike) {
    for (const double limit : {0.001, 20.0, 60.0, 240.0}) {
        MadeUp measurer(drawnSettings(3), 0.1, 3);
        measurer.secondsOfPreparing = 0.1;
        measurer.secondsOfFrame = 0.05;
        measurer.secondsOfView = 0.2;
        const auto standings = halve(40, {40, 16, false, false, limit}, measurer);
        const double least = 40 * (0.1 + 0.05 + 0.1 + 0.2);
        EXPECT_LE(measurer.clock(), std::max(limit, least) + 1e-9);
        std::size_t most = 0;
        for (const Standing& standing : standings)
            most = std::max(most, standing.evidence.views.size());
        for (const Standing& standing : standings) {
            EXPECT_GE(standing.evidence.frameMs.size(), 1u);
            EXPECT_GE(standing.evidence.views.size(), 1u);
            EXPECT_TRUE(standing.dominator || standing.evidence.views.size() == most);
        }
    }
}

TEST(Halving, FramesAndViewsThatAreKeptAreMeasuredHoweverLongTheyTake) {
    MadeUp measurer({{10.0, 10.0, -1}, {5.0, 3000.0, -1}}, 0.1, 4);
    measurer.secondsOfFrame = measurer.secondsOfView = 10.0;
    for (const Standing& standing : halve(2, {12, 6, true, true, 1.0}, measurer)) {
        EXPECT_EQ(standing.evidence.frameMs.size(), 12u);
        EXPECT_EQ(standing.evidence.views.size(), 6u);
    }
}

TEST(Halving, OfNothingThereIsNothing) {
    MadeUp measurer({}, 0.1, 5);
    EXPECT_TRUE(halve(0, {}, measurer).empty());
}

TEST(Estimates, OfWhatWasDroppedAreByItsDominator) {
    // The machine was twice as slow during the first frames, and their view was an easy one.
    const std::vector<Standing> standings = {
        {{{20.0, 20.0, 10.0, 10.0, 10.0}, {{10, 0, 1000}, {90, 0, 1000}}}, 4, std::nullopt},
        {{{30.0, 30.0}, {{30, 20, 1000}}}, 1, 0},
        {{{60.0}, {{40, 0, 1000}}}, 1, 1}};
    const auto estimates = estimatesOf(standings);
    EXPECT_NEAR(estimates[0].milliseconds, 10.0, 1e-9);
    EXPECT_NEAR(estimates[1].milliseconds, 15.0, 1e-9);
    EXPECT_NEAR(estimates[2].milliseconds, 30.0, 1e-9);
    EXPECT_NEAR(estimates[0].wrongPercent, 5.0, 1e-9);
    EXPECT_NEAR(estimates[1].wrongPercent, 7.0, 1e-9);
    EXPECT_NEAR(estimates[1].beyond1pxPercent, 2.0, 1e-9);
    EXPECT_NEAR(estimates[2].wrongPercent, 8.0, 1e-9);
}

TEST(Estimates, BoundsAreAboveWhatWasMeasured) {
    const auto estimates = estimatesOf(std::vector<Standing>{
        {{{9.0, 10.0, 11.0, 12.0, 13.0, 14.0}, {{10, 0, 1000}, {20, 0, 1000}}}, 1, {}}});
    EXPECT_GE(estimates[0].millisecondsBelow, estimates[0].milliseconds);
    EXPECT_GT(estimates[0].wrongPercentBelow, estimates[0].wrongPercent);
}

TEST(Confidence, QuantilesAreThoseOfTables) {
    EXPECT_NEAR(studentQuantile(1, Surety::certain), 63.66, 0.01);
    EXPECT_NEAR(studentQuantile(7, Surety::certain), 3.499, 0.01);
    EXPECT_NEAR(studentQuantile(15, Surety::certain), 2.947, 0.003);
    EXPECT_NEAR(studentQuantile(7, Surety::likely), 2.365, 0.005);
    EXPECT_NEAR(studentQuantile(1000, Surety::likely), 1.962, 0.001);
}

TEST(Confidence, RatiosOfOnePairSayNothing) {
    const std::vector<double> one = {2.0}, other = {1.0};
    EXPECT_TRUE(std::isinf(logRatioBounds(one, other, 0.1).low));
    const std::vector<double> twice = {2.0, 4.0, 6.0}, half = {1.0, 2.0, 3.0};
    const Bounds bounds = logRatioBounds(twice, half, 0.01);
    EXPECT_LT(bounds.low, std::log(2.0));
    EXPECT_GT(bounds.low, 0.7 * std::log(2.0));
}

TEST(Confidence, TheMedianIsSeldomAboveItsBound) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> values(0.0, 0.5); // its median is 1
    for (const std::size_t count : {6u, 10u, 40u, 400u}) {
        int above = 0;
        for (int i = 0; i < 1000; ++i) {
            std::vector<double> drawn;
            for (std::size_t k = 0; k < count; ++k)
                drawn.push_back(values(random));
            above += medianBelow(drawn) < 1.0;
        }
        EXPECT_LE(above, 40) << count; // at most 25 are expected
    }
    EXPECT_EQ(medianBelow({}), 0.0);
    EXPECT_EQ(medianBelow(std::vector{1.0, 3.0}), 3.0); // too few values to tell
}

TEST(Confidence, TheMeanIsSeldomAboveItsBound) {
    std::mt19937 random(8);
    std::normal_distribution<double> values(1.0, 0.5);
    int above = 0;
    for (int i = 0; i < 1000; ++i) {
        std::vector<double> drawn;
        for (int k = 0; k < 8; ++k)
            drawn.push_back(values(random));
        above += meanBelow(drawn) < 1.0;
    }
    EXPECT_LE(above, 40); // 25 are expected
    EXPECT_EQ(meanBelow(std::vector{3.0}), 3.0);
}

} // namespace
} // namespace edgeshade::bench
