#include "src/hours/surfaces/cell_light.hpp"

#include "src/hours/surfaces/division.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

/// A floor of one cell, and four positions at the ends of two months on a clock an hour ahead.
class CellLightTest : public testing::Test {
  protected:
    CellLightTest() {
        cells_ = cellsOf(test::SceneBuilder().floor(0.25f).scene(),
                         [](std::uint32_t, std::uint32_t) { return true; }, {0.5, 0.0});
        for (const char* time :
             {"2026-01-31T12:00Z", "2026-01-31T22:59Z", "2026-01-31T23:00Z", "2026-02-01T12:00Z"})
            positions_.push_back({sun::localTimeFromText(time).instant, 0.0, 30.0,
                                  glm::dvec3(0.0, 0.5, std::sqrt(0.75))});
        question_.positions = positions_;
        question_.step = minutes(30);
        question_.offset = minutes(60);
    }

    /// The light of positions whose bits are set, from the lowest on.
    CellLight measured(std::uint64_t lit) const {
        return lightOf(
            cells_, question_,
            [lit](std::span<const Sensor> sensors, std::span<const glm::dvec3> directions) {
                rays::LitBits bits(sensors.size(), directions.size());
                for (std::size_t s = 0; s < sensors.size(); ++s)
                    for (std::size_t d = 0; d < directions.size(); ++d)
                        if (lit >> d & 1) bits.setLit(s, d);
                return bits;
            },
            [](double) {});
    }

    SurfaceCells cells_;
    std::vector<Position> positions_;
    LightQuestion question_;
};

} // namespace

TEST_F(CellLightTest, CountsAndSaysWhichWereTheFirstAndTheLast) {
    const CellLight some = measured(0b0110);
    EXPECT_EQ(some.lit, std::vector<std::uint32_t>{2});
    EXPECT_EQ(some.first[0], 1u);
    EXPECT_EQ(some.last[0], 2u);
    EXPECT_TRUE(some.months.empty());
    EXPECT_TRUE(some.bits.empty());
    EXPECT_TRUE(some.directKwh.empty());
    EXPECT_EQ(measured(0).first[0], CellLight::never);
    EXPECT_EQ(measured(0).last[0], CellLight::never);
}

TEST_F(CellLightTest, CountsMonthsByTheClock) {
    // 23:00 UTC on 31 January is midnight, and so February, on a clock an hour ahead.
    question_.months = true;
    const CellLight all = measured(0b1111);
    EXPECT_EQ(all.months[0][0], 2u);
    EXPECT_EQ(all.months[0][1], 2u);
    EXPECT_EQ(all.months[0][2], 0u);
}

TEST_F(CellLightTest, PacksBitsAsNumPyDoes) {
    question_.bits = true;
    EXPECT_EQ(measured(0b0011).bits, std::vector<std::uint8_t>{0b1100'0000});
    EXPECT_EQ(measured(0b1000).bits, std::vector<std::uint8_t>{0b0001'0000});
}

TEST_F(CellLightTest, SumsTheBeamByItsAngle) {
    // 800 W/m² for half an hour, at 30 degrees above a level cell: 0.2 kWh/m².
    const std::vector<double> irradiance = {800.0, 0.0, 400.0, 0.0};
    question_.normalIrradiance = irradiance;
    EXPECT_NEAR(measured(0b0011).directKwh[0], 0.2, 1e-12);
    EXPECT_NEAR(measured(0b1111).directKwh[0], 0.3, 1e-12);
}

} // namespace edgeshade::hours
