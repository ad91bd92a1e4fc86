#include "src/sun/refraction.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {

using sun::refraction;

// Refraction of 34' lifts the sun to the horizon. Above it, Bennett's formula (Journal of
// Navigation 35, 1982), which starts from the refracted altitude, gives the airless altitude back.
TEST(Refraction, IsThatOfTheStandardAtmosphere) {
    EXPECT_NEAR(refraction(-34.0 / 60.0, {}) * 60.0, 34.0, 0.5);
    for (double altitude = 0.0; altitude < 89.0; altitude += 0.5) {
        const double seen = altitude + refraction(altitude, {});
        const double bennett = 1.0 / std::tan(glm::radians(seen + 7.31 / (seen + 4.4)));
        EXPECT_NEAR(refraction(altitude, {}) * 60.0, bennett, 0.1) << altitude;
    }
    EXPECT_EQ(refraction(90.0, {}), 0.0);
}

TEST(Refraction, GoesWithTheAirsDensity) {
    EXPECT_EQ(refraction(10.0, {0.0, 10.0}), 0.0);
    EXPECT_DOUBLE_EQ(refraction(10.0, {505.0, 10.0}), refraction(10.0, {}) / 2.0);
    EXPECT_LT(refraction(10.0, {1010.0, 40.0}), refraction(10.0, {}));
}

TEST(Refraction, KeepsTheOrderOfAltitudesAndHasNoJump) {
    double last = -90.0;
    for (int i = 1; i <= 180000; ++i) {
        const double altitude = -90.0 + i / 1000.0;
        const double seen = altitude + refraction(altitude, {});
        EXPECT_GT(seen, last) << altitude;
        EXPECT_LT(seen - last, 0.003) << altitude;
        last = seen;
    }
    EXPECT_EQ(refraction(-5.0, {}), 0.0);
}

} // namespace edgeshade::test
