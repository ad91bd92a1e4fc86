#include "src/plot/hours_sheet.hpp"

#include "src/image/decode.hpp"
#include "src/plot/color_scale.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::plot {
namespace {

struct Lab {
    double lightness, a, b;
};

/// CIELAB of a colour under D65: a measure other than the one that made the scale.
Lab cielab(Color color) {
    double linear[3];
    for (int c = 0; c < 3; ++c) {
        const double v = (color >> (16 - 8 * c) & 0xFF) / 255.0;
        linear[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f((0.4124 * linear[0] + 0.3576 * linear[1] + 0.1805 * linear[2]) / 0.95047);
    const double y = f(0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]);
    const double z = f((0.0193 * linear[0] + 0.1192 * linear[1] + 0.9505 * linear[2]) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

} // namespace

TEST(ColorScale, GrowsLighterAndYellowerAllTheWay) {
    for (int i = 0; i < 64; ++i) {
        const Lab low = cielab(evenColor(i / 64.0)), high = cielab(evenColor((i + 1) / 64.0));
        EXPECT_GT(high.lightness, low.lightness) << i;
        EXPECT_GT(high.b, low.b - 0.5) << i;
    }
    EXPECT_LT(cielab(evenColor(0.0)).lightness, 15.0);
    EXPECT_GT(cielab(evenColor(1.0)).lightness, 88.0);
}

TEST(ColorScale, StepsOfLightnessAreEven) {
    const double whole = cielab(evenColor(1.0)).lightness - cielab(evenColor(0.0)).lightness;
    for (int i = 0; i < 8; ++i) {
        const double step =
            cielab(evenColor((i + 1) / 8.0)).lightness - cielab(evenColor(i / 8.0)).lightness;
        EXPECT_NEAR(step, whole / 8.0, 0.2 * whole / 8.0) << i;
    }
}

TEST(ColorScale, EndsAreKeptBeyond) {
    EXPECT_EQ(evenColor(-1.0), evenColor(0.0));
    EXPECT_EQ(evenColor(2.0), evenColor(1.0));
}

TEST(HoursSheet, TicksAreRoundAndFew) {
    EXPECT_EQ(scaleTicks(12.0), (std::vector<double>{0, 2, 4, 6, 8, 10, 12}));
    EXPECT_EQ(scaleTicks(1.0).back(), 1.0);
    for (double most = 0.17; most < 9000.0; most *= 1.3) {
        const std::vector<double> ticks = scaleTicks(most);
        EXPECT_GE(ticks.size(), 3u) << most;
        EXPECT_LE(ticks.size(), 7u) << most;
        EXPECT_LE(ticks.back(), most * 1.0001);
    }
}

TEST(HoursSheet, ShowsEveryPixelOfThePicture) {
    HoursSheet sheet;
    sheet.title = "T";
    sheet.width = 31;
    sheet.height = 17;
    for (int i = 0; i < 31 * 17; ++i)
        for (const int value : {i % 256, i / 2 % 256, 77, 255})
            sheet.rgba.push_back(static_cast<std::uint8_t>(value));
    const Image image = decodeImage(hoursPng(sheet), "sheet");
    // The picture appears unchanged somewhere in the sheet.
    const auto row = [&](int x, int y, int line) {
        const auto width = static_cast<std::size_t>(image.width);
        return std::equal(
            sheet.rgba.begin() + line * 31 * 4, sheet.rgba.begin() + (line + 1) * 31 * 4,
            image.rgba.begin() +
                static_cast<std::ptrdiff_t>(4 * ((static_cast<std::size_t>(y + line)) * width +
                                                 static_cast<std::size_t>(x))));
    };
    int found = 0;
    for (int y = 0; y + 17 <= static_cast<int>(image.height); ++y)
        for (int x = 0; x + 31 <= static_cast<int>(image.width); ++x) {
            int line = 0;
            while (line < 17 && row(x, y, line))
                ++line;
            found += line == 17;
        }
    EXPECT_EQ(found, 1);
}

} // namespace edgeshade::plot
