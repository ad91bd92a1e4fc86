// Halos hold every caster that shades, and leave out those where the sun never is and those that
// are too low.

#include "src/city/caster_filter.hpp"
#include "src/hours/schedule.hpp"

#include <gtest/gtest.h>
#include <random>
#include <set>

namespace edgeshade::city {
namespace {

using namespace std::chrono;

std::vector<hours::Position> sunOf(sys_days from, sys_days to, minutes interval) {
    hours::Schedule schedule;
    schedule.place = {48.14, 11.57};
    schedule.from = from;
    schedule.to = to;
    schedule.step = interval;
    schedule.minAltitude = 5.0;
    return hours::positionsOf(schedule);
}

std::vector<hours::Position> springDay() {
    return sunOf(2026y / March / 20, 2026y / March / 20, minutes(10));
}

/// A square of cells of a metre whose south-western corner is at a place.
TargetBox squareAt(std::int64_t x, std::int64_t y, std::int64_t side, double lowest) {
    return {{x, y, x + side, y + side}, 1.0, lowest};
}

class SunFanTest : public testing::TestWithParam<std::vector<hours::Position>> {};

TEST_P(SunFanTest, MissesNoCaster) {
    const std::vector<hours::Position>& positions = GetParam();
    const SunFan fan(positions);
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    for (int i = 0; i < 20000; ++i) {
        const auto corner = std::int64_t{i % 2 == 0 ? 1 << 10 : 1 << 28};
        const TargetBox target = squareAt(-corner, corner, 1 << i % 12, 300.0);
        // A box with a point on a ray from a point of the target, which may be its corner.
        const glm::dvec3 sun = positions[random() % positions.size()].direction;
        const glm::dvec3 from(i % 3 == 0 ? target.west : between(target.west, target.east),
                              i % 5 == 0 ? target.north : between(target.south, target.north),
                              target.lowest + (i % 4 == 0 ? 0.0 : between(0.0, 50.0)));
        const glm::dvec3 at = from + std::exp(between(0.0, 9.0)) * glm::dvec3(sun.x, -sun.z, sun.y);
        Box box;
        box.add(at);
        if (i % 2 == 1) box.add(at - glm::dvec3(between(-9.0, 9.0), between(-9.0, 9.0), 5.0));
        ASSERT_TRUE(fan.mayShade(box, target)) << i;
        ASSERT_LE(fan.leastHeight(box, target), box.high.z) << i;
    }
}

std::vector<hours::Position> zenith() {
    hours::Position position;
    position.direction = glm::dvec3(0.0, 1.0, 0.0);
    return {position};
}

INSTANTIATE_TEST_SUITE_P(Suns, SunFanTest,
                         testing::Values(springDay(), zenith(),
                                         sunOf(2026y / January / 1, 2026y / December / 31,
                                               minutes(30))));

TEST(SunFan, LooksTowardsTheSunAlone) {
    const TargetBox target = squareAt(0, 0, 100, 0.0);
    const auto towerAt = [](double x, double y) {
        Box box;
        box.add({x, y, 0.0});
        box.add({x + 10.0, y + 10.0, 60.0});
        return box;
    };
    const SunFan fan(springDay());
    EXPECT_TRUE(fan.mayShade(towerAt(400.0, 50.0), target));  // morning
    EXPECT_TRUE(fan.mayShade(towerAt(-400.0, 50.0), target)); // evening
    EXPECT_TRUE(fan.mayShade(towerAt(50.0, -50.0), target));  // noon, at 42 degrees
    EXPECT_FALSE(fan.mayShade(towerAt(50.0, -120.0), target));
    EXPECT_FALSE(fan.mayShade(towerAt(50.0, 110.0), target)); // the sun is never in the north
    EXPECT_TRUE(fan.mayShade(towerAt(50.0, 50.0), target));
    EXPECT_FALSE(fan.mayShade(towerAt(900.0, 50.0), target)); // 60 m / tan(5) is 686 m
    // Without sun nothing shades, but surfaces below the cells count.
    const SunFan night({});
    EXPECT_TRUE(night.mayShade(towerAt(50.0, 50.0), target));
    EXPECT_FALSE(night.mayShade(towerAt(101.0, 50.0), target));
}

TEST(SunFan, KnowsTheLeastHeightOfCasters) {
    const TargetBox target = squareAt(0, 0, 100, 7.0);
    const SunFan fan(springDay());
    for (const glm::dvec2 at : {glm::dvec2(400.0, 50.0), {-90.0, 20.0}, {50.0, -120.0}}) {
        Box box;
        box.add({at, 0.0});
        const double least = fan.leastHeight(box, target);
        EXPECT_GT(least, target.lowest);
        box.high.z = least + 1e-9;
        EXPECT_TRUE(fan.mayShade(box, target)) << at.x;
        box.high.z = least - 1e-9;
        EXPECT_FALSE(fan.mayShade(box, target)) << at.x;
    }
    Box under;
    under.add({50.0, 50.0, -9.0});
    EXPECT_EQ(fan.leastHeight(under, target), target.lowest);
    Box north;
    north.add({50.0, 300.0, 0.0});
    EXPECT_EQ(fan.leastHeight(north, target), HUGE_VAL); // where the sun never is
}

/// A slope of cells of 2 m that rises to the east, with a gap.
struct Slope {
    CellRange cells{-32, 500, 32, 540};
    double width = 2.0;

    double heightAt(std::int64_t column) const { return 100.0 + 1.5 * width * double(column); }
    bool isGap(std::int64_t column, std::int64_t row) const {
        return column < -16 && row < 520; // the lowest, with whole squares
    }
    std::vector<double> heights() const {
        std::vector<double> heights;
        for (std::int64_t row = cells.bottom; row < cells.top; ++row)
            for (std::int64_t column = cells.left; column < cells.right; ++column)
                heights.push_back(isGap(column, row) ? HUGE_VAL : heightAt(column));
        return heights;
    }
};

TEST(CasterFilter, LeavesOutOnlyWhatShadesNoCell) {
    const Slope slope;
    const std::vector<hours::Position> positions = springDay();
    const SunFan fan(positions);
    const CasterFilter filter(fan, slope.cells, slope.width, slope.heights());
    std::mt19937 random(3);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    // Triangles whose highest corner is on a ray from a cell, or from the lowest height below it.
    std::vector<CityTriangle> shading, others;
    while (shading.size() < 4000) {
        const std::int64_t column = slope.cells.left + std::int64_t(random() % 64),
                           row = slope.cells.bottom + std::int64_t(random() % 40);
        if (slope.isGap(column, row)) continue;
        const glm::dvec3 sun = positions[random() % positions.size()].direction;
        const glm::dvec3 along = std::exp(between(4.0, 7.0)) * glm::dvec3(sun.x, -sun.z, sun.y);
        const auto triangleFrom = [&](double height) {
            const glm::dvec3 at =
                glm::dvec3(middleOf(column, slope.width), middleOf(row, slope.width), height) +
                along;
            return CityTriangle{
                {at, at + glm::dvec3(-3.0, 0.0, -2.0), at + glm::dvec3(0.0, 3.0, -1.0)}};
        };
        shading.push_back(triangleFrom(slope.heightAt(column)));
        others.push_back(triangleFrom(slope.heightAt(slope.cells.left)));
    }
    std::size_t count = 0, kept = 0;
    filter.forEach(shading, [&](const CityTriangle&) { ++count; });
    EXPECT_EQ(count, shading.size());
    // A test against the lowest of all cells would use every other, too.
    for (const CityTriangle& triangle : others)
        filter.forEach(std::span(&triangle, 1), [&](const CityTriangle&) { ++kept; });
    EXPECT_LT(kept, others.size() * 3 / 4);
    EXPECT_GT(kept, 0u);
}

TEST(CasterFilter, UsesNothingWhereNoCellHasASurface) {
    const SunFan fan(springDay());
    const CasterFilter filter(fan, {0, 0, 4, 4}, 1.0, std::vector<double>(16, HUGE_VAL));
    const std::vector<CityTriangle> triangles = {
        {{glm::dvec3(0.0), glm::dvec3(4.0, 0.0, 9.0), glm::dvec3(0.0, 4.0, 9.0)}}};
    filter.forEach(triangles, [](const CityTriangle&) { ADD_FAILURE(); });
}

TEST(PartTree, FindsWhatALoopFinds) {
    std::mt19937 random(2);
    const auto upTo = [&](double most) {
        return std::uniform_real_distribution(0.0, most)(random);
    };
    std::vector<CityTriangle> triangles;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 corner(upTo(3000.0), upTo(200.0), upTo(100.0));
        triangles.push_back({{corner, corner + glm::dvec3(upTo(30.0), 0.0, upTo(9.0)),
                              corner + glm::dvec3(0.0, upTo(30.0), 0.0)}});
    }
    const std::vector<Part> parts = partsOf(triangles, 7);
    EXPECT_GT(parts.size(), 16u);
    EXPECT_LE(parts.size(), 256u);
    std::uint64_t sum = 0;
    for (const Part& part : parts) {
        EXPECT_EQ(part.source, 7u);
        sum += part.triangles;
    }
    EXPECT_EQ(sum, triangles.size());
    const SunFan fan(springDay());
    const PartTree tree(parts);
    std::size_t some = 0, none = 0;
    for (int x = -2000; x < 5000; x += 300) {
        const TargetBox target = squareAt(x, 100, 64, 20.0);
        const auto accept = [&](const Box& box) { return fan.mayShade(box, target); };
        std::multiset<double> found, expected;
        tree.forEach(accept, [&](const Part& part) { found.insert(part.box.low.x); });
        for (const Part& part : parts)
            if (accept(part.box)) expected.insert(part.box.low.x);
        EXPECT_EQ(found, expected);
        // A part with a triangle that may shade may shade, too.
        for (const CityTriangle& triangle : triangles)
            if (accept(triangle.box())) {
                EXPECT_TRUE(std::ranges::any_of(parts, [&](const Part& part) {
                    return accept(part.box) && part.box.holds(triangle.box().low) &&
                           part.box.holds(triangle.box().high);
                }));
            }
        (found.empty() ? none : some) += 1;
    }
    EXPECT_GT(some, 3u);
    EXPECT_GT(none, 3u);
    PartTree({}).forEach([](const Box&) { return true; },
                         [](const Part&) { ADD_FAILURE() << "an empty tree has a part"; });
}

} // namespace
} // namespace edgeshade::city
