#include "src/image/decode.hpp"
#include "src/plot/labels.hpp"
#include "src/plot/log_axis.hpp"
#include "src/plot/trade_plot.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

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
    return {"A & B",
            "two < three",
            "time of a frame, ms",
            {"volumes", "maps", "no shadows", "nobody's"},
            {{"volumes", 0, 12.0, 0.0, 3 << 20, true, ""},
             {"map 1024", 1, 3.0, 2.5, 0, true, ""},
             {"map 4096", 1, 14.0, 0.7, 0, false, "dominated early by <volumes>"},
             {"no shadows", 2, 1.0, 30.0, 0, true, ""}}};
}

/// More settings than tradeoff has, crowded, with a dozen on the front.
TradePlot crowd() {
    TradePlot plot = example();
    plot.points.clear();
    plot.families.clear();
    for (std::size_t i = 0; i < 48; ++i) {
        plot.families.push_back("family " + std::to_string(i / 3));
        const bool front = i % 4 == 0;
        const double t = 10.0 + 0.25 * static_cast<double>(i), worse = front ? 1.0 : 1.4;
        plot.points.push_back({"a setting " + std::to_string(i), i / 3, t,
                               worse * 100.0 / (t * t * t), i << 20, front, ""});
    }
    return plot;
}

/// Records texts and marks.
class Record : public Canvas {
  public:
    struct Mark {
        Shape shape;
        Color fill, rim;
        Point center;
    };
    std::vector<Mark> marks;
    std::vector<std::pair<std::string, Rectangle>> names; ///< bold, with the width that is assumed
                                                          ///< for them

    void line(std::span<const Point>, Color, double, bool) override {}
    void mark(Point center, Shape shape, double, Color fill, Color rim,
              const std::string&) override {
        marks.push_back({shape, fill, rim, center});
    }
    void rectangle(const Rectangle&, Color) override {}
    void image(const Rectangle&, std::span<const std::uint8_t>, int, int) override {}
    void text(Point at, const std::string& text, const TextStyle& style) override {
        const double half = 0.34 * style.size * static_cast<double>(text.size());
        if (style.bold && style.anchor == Anchor::middle)
            names.push_back({text, {at.x - half, at.y - style.size, at.x + half, at.y}});
    }
    Bytes file() override { return {}; }
};

std::string svgOf(const TradePlot& plot) {
    const auto canvas = svgCanvas(tradePlotWidth, tradePlotHeight);
    drawTradePlot(*canvas, plot);
    const Bytes bytes = canvas->file();
    return {bytes.begin(), bytes.end()};
}

TEST(TradePlot, AsSvgNamesTheFrontAndSaysWhatItShows) {
    const std::string svg = svgOf(example());
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    for (const char* text : {">volumes</text>", ">map 1024</text>", ">no shadows</text>",
                             "A &amp; B", "two &lt; three", "time of a frame, ms", "percent"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    EXPECT_EQ(svg.find(">map 4096</text>"), std::string::npos);
}

TEST(TradePlot, AsSvgSaysTheFiguresOfEveryPointWhereThePointerRests) {
    const std::string svg = svgOf(example());
    for (const char* text :
         {"<title>volumes\n12 ms, 0 % wrong, 3 MB on the GPU</title>",
          "<title>map 4096\n14 ms, 0.7 % wrong, 0 MB on the GPU\ndominated early by "
          "&lt;volumes&gt;</title>"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(TradePlot, FamiliesDifferInColourOrMarkAndOnlyThoseThereAreAreInTheLegend) {
    EXPECT_EQ(svgOf(example()).find("nobody's"), std::string::npos);
    Record record;
    drawTradePlot(record, crowd());
    std::set<std::pair<Shape, Color>> looks;
    for (const Record::Mark& mark : record.marks)
        if (mark.center.x > 900.0) looks.insert({mark.shape, mark.rim}); // the legend
    EXPECT_GE(looks.size(), 16u);
}

TEST(TradePlot, NamesOfTheFrontKeepOutOfEachOthersWay) {
    Record record;
    drawTradePlot(record, crowd());
    ASSERT_EQ(record.names.size(), 12u);
    for (std::size_t i = 0; i < record.names.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(meet(record.names[i].second, record.names[j].second))
                << record.names[i].first << " and " << record.names[j].first;
}

TEST(Shapes, AreAroundTheirPlaceAndAboutAsLarge) {
    for (int i = 0; i < shapeCount; ++i) {
        const auto corners = outlineOf(static_cast<Shape>(i), {50.0, 70.0}, 5.0);
        EXPECT_EQ(corners.empty(), static_cast<Shape>(i) == Shape::disc);
        Point sum;
        for (const Point& corner : corners) {
            sum.x += corner.x / static_cast<double>(corners.size());
            sum.y += corner.y / static_cast<double>(corners.size());
            EXPECT_LE(std::hypot(corner.x - 50.0, corner.y - 70.0), 7.6);
        }
        if (corners.empty()) continue;
        EXPECT_NEAR(sum.x, 50.0, 1e-9);
        EXPECT_NEAR(sum.y, 70.0, 1e-9);
    }
}

TEST(TradePlot, TimesThatTheClockCannotTellHaveAPlaceToo) {
    TradePlot plot = example();
    for (TradePoint& point : plot.points)
        point.milliseconds = 0.0;
    const std::string svg = svgOf(plot);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
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
