#include "src/hours/exposure.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using std::chrono::minutes;

/// Four pixels: two of material 0, one of 1, one without a surface; one has no area.
Exposure fourPixels() {
    Exposure exposure;
    exposure.width = 4;
    exposure.height = 1;
    exposure.lit = {6, 12, 9, 99};
    exposure.surface = {1, 1, 1, 0};
    exposure.area = {1.0f, 3.0f, 4.0f, 0.0f};
    exposure.material = {0, 0, 1, Exposure::none};
    exposure.node = exposure.material;
    return exposure;
}

} // namespace

TEST(Exposure, IsWeighedByArea) {
    const HoursSummary all = summaryOf(fourPixels(), minutes(10), 1.5);
    EXPECT_EQ(all.area, 8.0);
    EXPECT_EQ(all.min, 1.0);
    EXPECT_EQ(all.max, 2.0);
    EXPECT_DOUBLE_EQ(all.mean, (1.0 * 1.0 + 3.0 * 2.0 + 4.0 * 1.5) / 8.0);
    EXPECT_EQ(all.areaAboveThreshold, 87.5); // 1.5 hours meet a threshold of 1.5
}

TEST(Exposure, ThresholdsAreMetByWholeSteps) {
    // Nine times ten minutes are 1.5 hours, 18 are 3, to the last bit.
    for (std::size_t lit = 1; lit < 1000; ++lit)
        EXPECT_EQ(hoursOf(6 * lit, minutes(10)), static_cast<double>(lit));
}

TEST(Exposure, IsSummedByGroup) {
    const Exposure exposure = fourPixels();
    const auto groups = summariesOf(exposure, exposure.material, minutes(10), 1.5);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].group, 0u);
    EXPECT_EQ(groups[0].hours.area, 4.0);
    EXPECT_EQ(groups[0].hours.areaAboveThreshold, 75.0);
    EXPECT_EQ(groups[1].hours.min, 1.5);
}

TEST(Exposure, HistogramsHoldAllArea) {
    const auto bins = histogramOf(fourPixels(), minutes(10), 1.0, 2);
    ASSERT_EQ(bins.size(), 2u);
    EXPECT_EQ(bins[0].area, 0.0);
    EXPECT_EQ(bins[1].area, 8.0); // including two hours, the end of the last bin
    EXPECT_EQ(bins[1].from, 1.0);
    EXPECT_EQ(bins[1].to, 2.0);
    EXPECT_EQ(histogramOf(fourPixels(), minutes(10), 1.25, 2)[0].area, 1.0);
}

TEST(Exposure, OfNothingIsNothing) {
    Exposure exposure = fourPixels();
    exposure.surface.assign(4, 0);
    const HoursSummary all = summaryOf(exposure, minutes(10), 1.5);
    EXPECT_EQ(all.area, 0.0);
    EXPECT_EQ(all.mean, 0.0);
    EXPECT_EQ(all.areaAboveThreshold, 0.0);
}

} // namespace edgeshade::hours
