// Planes around everything between a light and a box.
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/planes_between.hpp"
#include "tests/support/hard_lights.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

std::vector<glm::dvec4> planesBetween(const glm::dvec4& light, const Box& box) {
    std::vector<glm::dvec4> planes;
    findPlanesBetween(light, box, planes);
    return planes;
}

using test::Random;

Box boxAt(const glm::dvec3& center, const glm::dvec3& half) {
    Box box;
    box.add(center - half);
    box.add(center + half);
    return box;
}

bool areOutside(const std::vector<glm::dvec4>& planes, const Box& box) {
    return std::any_of(planes.begin(), planes.end(),
                       [&](const glm::dvec4& plane) { return isOutside(box, plane); });
}

} // namespace

TEST(PlanesBetween, HoldAllSegmentsToTheLight) {
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const double scale = random.magnitude(-6.0, 6.0);
        const Box box =
            boxAt(scale * random.inCube(),
                  i % 5 == 0 ? glm::dvec3(0.0) : 0.3 * scale * glm::abs(random.inCube()));
        glm::dvec4 light(scale * 2.0 * random.inCube(), i % 2);
        if (i % 7 == 0) light.y = 0.0;                   // along an axis' plane
        if (i % 11 == 0) light = glm::dvec4(0, 1, 0, 0); // along an axis
        if (i % 13 == 0) light = glm::dvec4(box.corner(i % 8), 1.0);
        const std::vector<glm::dvec4> planes = planesBetween(light, box);
        for (int point = 0; point < 20; ++point) {
            const glm::dvec3 share = 0.5 + 0.5 * random.inCube();
            const glm::dvec3 end = box.low + share * (box.high - box.low);
            const double along = random.uniform(0.0, 1.0);
            const glm::dvec3 at = light.w == 0.0
                                      ? end + random.magnitude(-3.0, 3.0) * glm::dvec3(light)
                                      : end + along * (glm::dvec3(light) - end);
            EXPECT_FALSE(areOutside(planes, boxAt(at, glm::dvec3(0.0)))) << i;
        }
    }
}

TEST(PlanesBetween, LeaveOutWhatIsBesideAndBehind) {
    const Box box = boxAt({0, 0, 0}, {1, 1, 1});
    const auto outside = [&](const glm::dvec4& light, const glm::dvec3& at) {
        return areOutside(planesBetween(light, box), boxAt(at, glm::dvec3(0.1)));
    };
    const glm::dvec4 sun(1, 1, 0, 0), lamp(10, 10, 0, 1);
    EXPECT_FALSE(outside(sun, {50, 50, 0}));
    EXPECT_TRUE(outside(sun, {50, 40, 0}));
    EXPECT_TRUE(outside(sun, {-2, -2, 0}));
    EXPECT_TRUE(outside(sun, {50, 50, 1.3}));
    EXPECT_FALSE(outside(lamp, {5, 5, 0.3}));
    EXPECT_TRUE(outside(lamp, {11, 11, 0})) << "beyond the lamp";
    EXPECT_TRUE(outside(lamp, {9, 9, 0.5})) << "the hull is narrow near the lamp";
    EXPECT_TRUE(outside(lamp, {-2, -2, 0}));
    EXPECT_TRUE(planesBetween(lamp, Box()).empty());
}

} // namespace edgeshade
