// Planes near a point, tested several at once.
#include "src/shadow/geometry/plane_columns.hpp"

#include "tests/support/hard_lights.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace edgeshade {
namespace {

using test::Random;

TEST(PlaneColumns, FindThePlanesThatATestOneByOneFinds) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Random random(53);
    std::size_t near = 0, far = 0;
    for (int i = 0; i < 500; ++i) {
        std::vector<glm::vec4> planes;
        PlaneColumns columns;
        for (int count = random.below(300); count > 0; --count) {
            glm::vec4 plane(glm::vec3(random.inCube()), static_cast<float>(random.inCube().x));
            if (random.below(20) == 0) plane = glm::vec4(0.0f); // a triangle without an area
            if (random.below(50) == 0) plane.x = 3e38f;         // overflows
            if (random.below(50) == 0) plane.w = infinity;      // no number for a sun
            planes.push_back(plane);
            columns.add(plane);
        }
        const glm::vec4 point(glm::vec3(10.0 * random.inCube()), random.below(2));
        // Often no plane of a block is near, and sometimes only its last.
        const float distance = random.below(2) ? 1e-2f : 1.0f;
        const auto end =
            static_cast<std::size_t>(random.below(static_cast<int>(planes.size()) + 1));
        std::vector<std::size_t> wanted, found;
        for (std::size_t p = 0; p < end; ++p) {
            const glm::vec4 terms = planes[p] * point;
            if (std::abs(terms.x + terms.y + terms.z + terms.w) <= distance) wanted.push_back(p);
        }
        columns.forNear(point, distance, end, [&](std::size_t p) { found.push_back(p); });
        ASSERT_EQ(found, wanted) << i;
        near += wanted.size();
        far += end - wanted.size();
    }
    EXPECT_GT(near, 1000u);
    EXPECT_GT(far, 1000u);
}

} // namespace
} // namespace edgeshade
