#include "src/hours/surfaces/windows.hpp"

#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using test::SceneBuilder;

bool all(std::uint32_t, std::uint32_t) {
    return true;
}

/// Light from the sides with positive x alone: inside is where x is negative.
rays::LitBits fromOutside(std::span<const Sensor> sensors, std::span<const glm::dvec3> directions) {
    rays::LitBits bits(sensors.size(), directions.size());
    for (std::size_t s = 0; s < sensors.size(); ++s)
        for (std::size_t d = 0; d < directions.size(); ++d)
            if (sensors[s].normal.x > 0.5 && glm::dot(sensors[s].normal, directions[d]) > 0.0)
                bits.setLit(s, d);
    return bits;
}

} // namespace

TEST(Windows, OfPanesAreTheOutsides) {
    // Two panes of 1 x 2, a centimetre thick; the side towards +x sees the sky.
    const SurfaceCells windows = windowsOf(
        SceneBuilder().box({0, 1, 0}, {0.01f, 3, 1}).box({0, 1, 4}, {0.01f, 3, 5}).scene(), all, {},
        fromOutside);
    ASSERT_EQ(windows.cells.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Cell& cell = windows.cells[i];
        EXPECT_EQ(cell.normal, glm::dvec3(1, 0, 0));
        EXPECT_NEAR(cell.area, 2.0, 1e-6);
        EXPECT_NEAR(cell.point.x, 0.01, 1e-9);
        EXPECT_NEAR(cell.point.y, 2.0, 0.02);
        EXPECT_NEAR(cell.point.z, 0.5 + 4.0 * static_cast<double>(i), 0.02);
    }
}

TEST(Windows, HaveTheirSensorsAsHighAsARuleSays) {
    // Panes of 1 x 2 from y = 1 on, upright and leaning by 3 : 4; one that is level has no height.
    const auto heightIn = [](const SceneBuilder& scene, double rise) {
        const WindowSettings settings{0.01, 0.0, rise};
        return windowsOf(scene.scene(), all, settings, fromOutside).cells.at(0).point;
    };
    const SceneBuilder upright = SceneBuilder().quad({0, 1, 1}, {0, 1, 0}, {0, 3, 0}, {0, 3, 1});
    const glm::dvec3 point = heightIn(upright, 0.3);
    EXPECT_NEAR(point.y, 1.3, 1e-6);
    EXPECT_NEAR(point.z, 0.5, 0.01);
    EXPECT_NEAR(heightIn(upright, 2.5).y, 2.0, 0.02); // beyond it: in the middle
    const SceneBuilder leaning = SceneBuilder().quad({0, 1, 1}, {0, 1, 0}, {-3, 5, 0}, {-3, 5, 1});
    EXPECT_NEAR(heightIn(leaning, 0.4).y, 1.4, 1e-6);
    const SceneBuilder level = SceneBuilder().floor(2);
    EXPECT_NEAR(heightIn(level, 0.3).z, 0.0, 0.05);
}

TEST(Windows, OfSheetsHaveOneSide) {
    // A sheet that faces away from the sky is a window too; its sensor stands off by the offset.
    const SurfaceCells windows =
        windowsOf(SceneBuilder().quad({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}).scene(), all,
                  {0.01, 0.1}, fromOutside);
    ASSERT_EQ(windows.cells.size(), 1u);
    EXPECT_EQ(windows.cells[0].normal, glm::dvec3(-1, 0, 0));
    EXPECT_NEAR(windows.cells[0].point.x, -0.1, 1e-12);
}

TEST(Windows, AreApartByMaterial) {
    // Two panes in one plane that share an edge, of two materials.
    const Scene scene = SceneBuilder()
                            .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
                            .material(Material())
                            .quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0})
                            .scene();
    EXPECT_EQ(windowsOf(scene, all, {}, fromOutside).cells.size(), 2u);
    EXPECT_EQ(windowsOf(
                  scene, [](std::uint32_t, std::uint32_t m) { return m == 1; }, {}, fromOutside)
                  .cells.size(),
              1u);
    EXPECT_TRUE(windowsOf(
                    scene, [](std::uint32_t, std::uint32_t) { return false; }, {}, fromOutside)
                    .cells.empty());
}

TEST(Windows, OfArchesHaveTheirSensorInsideThem) {
    // A triangle's rectangle has its middle on the long side.
    const SurfaceCells windows = windowsOf(
        SceneBuilder().triangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}).scene(), all, {}, fromOutside);
    ASSERT_EQ(windows.cells.size(), 1u);
    const glm::dvec3 point = windows.cells[0].point;
    EXPECT_LT(point.x / 2.0 + point.y, 1.0);
    EXPECT_GT(point.x, 0.5);
}

} // namespace edgeshade::hours
