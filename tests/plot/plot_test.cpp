#include "src/image/decode.hpp"
#include "src/plot/labels.hpp"
#include "src/plot/log_axis.hpp"
#include "src/plot/trade_plot.hpp"

#include <gtest/gtest.h>

namespace edgeshade::plot {
namespace {

TEST(LogAxis, EqualRatiosAreEqualLengths) {
    const LogAxis axis(1.0, 100.0, 0.0, 200.0);
    EXPECT_NEAR(axis.at(1.0), 0.0, 1e-9);
    EXPECT_NEAR(axis.at(10.0), 100.0, 1e-9);
    EXPECT_NEAR(axis.at(100.0), 200.0, 1e-9);
}

TEST(LogAxis, HasPowersOfTenAndBetweenFewOfThemMore) {
    EXPECT_EQ(LogAxis(1e-4, 10.0, 0.0, 1.0).ticks().size(), 6u);
    const auto ticks = LogAxis(3.0, 60.0, 0.0, 1.0).ticks();
    ASSERT_EQ(ticks.size(), 4u);
    EXPECT_NEAR(ticks[0], 5.0, 1e-9);
    EXPECT_NEAR(ticks[3], 50.0, 1e-9);
}

TEST(LogAxis, LabelsHaveNoMoreDigitsThanTheyNeed) {
    EXPECT_EQ(tickLabel(0.0001), "0.0001");
    EXPECT_EQ(tickLabel(0.05), "0.05");
    EXPECT_EQ(tickLabel(1.0), "1");
    EXPECT_EQ(tickLabel(2000.0), "2000");
}

bool meet(const Rectangle& a, const Rectangle& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(Labels, KeepOutOfEachOthersWay) {
    const Rectangle inside{0.0, 0.0, 400.0, 300.0};
    const std::vector<Point> points = {{100, 100}, {104, 101}, {108, 100}, {5, 5}, {396, 150}};
    LabelPlaces places(inside, points, 5.0);
    std::vector<Rectangle> labels;
    for (const Point& point : points)
        labels.push_back(places.place(point, 60.0, 13.0));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_GE(labels[i].left, inside.left);
        EXPECT_GE(labels[i].top, inside.top);
        EXPECT_LE(labels[i].right, inside.right);
        EXPECT_LE(labels[i].bottom, inside.bottom);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(meet(labels[i], labels[j])) << i << " and " << j;
    }
}

TradePlot example() {
    using Family = TradePoint::Family;
    return {"A & B",
            "two < three",
            "time of a frame, ms",
            {{"volumes", Family::volumes, 12.0, 0.0, true},
             {"map 1024", Family::map, 3.0, 2.5, true},
             {"map 4096", Family::map, 14.0, 0.7, false},
             {"no shadows", Family::none, 1.0, 30.0, true}}};
}

std::string svgOf(const TradePlot& plot) {
    const auto canvas = svgCanvas(tradePlotWidth, tradePlotHeight);
    drawTradePlot(*canvas, plot);
    const Bytes bytes = canvas->file();
    return {bytes.begin(), bytes.end()};
}

TEST(TradePlot, AsSvgNamesEveryPointAndSaysWhatItShows) {
    const std::string svg = svgOf(example());
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    for (const char* text : {">volumes<", ">map 1024<", ">map 4096<", ">no shadows<", "A &amp; B",
                             "two &lt; three", "time of a frame, ms", "percent"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(TradePlot, IsTheSameEveryTime) {
    EXPECT_EQ(svgOf(example()), svgOf(example()));
}

TEST(TradePlot, WhatIsWrongNowhereHasAPlaceToo) {
    TradePlot plot = example();
    for (TradePoint& point : plot.points)
        point.wrongPercent = 0.0;
    const std::string svg = svgOf(plot);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(TradePlot, AsPngIsAPictureTwiceAsLarge) {
    std::unique_ptr<Canvas> canvas;
    try {
        canvas = pngCanvas(tradePlotWidth, tradePlotHeight);
    } catch (const std::exception&) {
        GTEST_SKIP() << "built without cairo";
    }
    drawTradePlot(*canvas, example());
    const Image image = decodeImage(canvas->file(), "plot");
    EXPECT_EQ(image.width, 2 * tradePlotWidth);
    EXPECT_EQ(image.height, 2 * tradePlotHeight);
    std::size_t inked = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        inked += image.rgba[i] < 128;
    EXPECT_GT(inked, 1000u);
    EXPECT_LT(inked, image.rgba.size() / 40);
}

} // namespace
} // namespace edgeshade::plot
