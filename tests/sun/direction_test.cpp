#include "src/sun/direction.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

void expectTowards(double azimuth, double altitude, double north, const glm::dvec3& expected) {
    const glm::dvec3 found = sun::towardsSun({azimuth, altitude, altitude}, north);
    EXPECT_LT(glm::distance(found, expected), 1e-12)
        << azimuth << " " << altitude << " " << north << ": " << found.x << "," << found.y << ","
        << found.z;
}

} // namespace

//      -Z, 0 degrees
//          |
//   -X ----+---- +X, 90        seen from above
//          |
//         +Z, 180
TEST(SunDirection, NorthIsMinusZAndEastIsX) {
    expectTowards(0.0, 0.0, 0.0, {0, 0, -1});
    expectTowards(90.0, 0.0, 0.0, {1, 0, 0});
    expectTowards(180.0, 0.0, 0.0, {0, 0, 1});
    expectTowards(270.0, 0.0, 0.0, {-1, 0, 0});
    expectTowards(123.0, 90.0, 45.0, {0, 1, 0});
}

TEST(SunDirection, NorthTurnsItClockwiseSeenFromAbove) {
    expectTowards(0.0, 0.0, 90.0, {1, 0, 0});
    expectTowards(90.0, 0.0, 90.0, {0, 0, 1});
    expectTowards(0.0, 0.0, -90.0, {-1, 0, 0});
    expectTowards(180.0, 30.0, 360.0, {0, 0.5, std::sqrt(0.75)});
}

} // namespace edgeshade::test
