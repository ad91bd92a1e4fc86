// The tree must find every triangle that an exact ray meets.
#include "src/rays/exact_blocking.hpp"
#include "src/rays/ray_tree.hpp"
#include "tests/support/hard_lights.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace edgeshade {
namespace {

using test::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Small triangles around the ends of rays, so that rays pass through corners and along edges.
TEST(RayTree, MissesNoTriangleThatARayMeets) {
    Random random(5);
    std::size_t met = 0, found = 0;
    for (int round = 0; round < 40; ++round) {
        const double scale = random.magnitude(-20, 20);
        const glm::dvec3 away = (round % 3) * 1e5 * random.inCube();
        std::vector<rays::Corners> corners;
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const glm::dvec3 at = random.inCube();
            const double size = random.magnitude(-7, -1);
            rays::Corners triangle;
            for (glm::dvec3& corner : triangle)
                corner = scale * (away + at + size * random.inCube());
            corners.push_back(triangle);
            all.push_back(i);
        }
        const rays::RayTree tree(corners, all);
        for (int i = 0; i < 200; ++i) {
            const rays::Corners& aim = corners[static_cast<std::size_t>(random.below(200))];
            const glm::dvec3 origin = scale * (away + 3.0 * random.inCube());
            const glm::dvec3 towards = (i % 2 ? aim[0] : glm::mix(aim[1], aim[2], 0.25)) - origin;
            std::vector<bool> candidate(corners.size(), false);
            tree.visit(origin, towards, infinity, [&](std::uint32_t triangle) {
                candidate[triangle] = true;
                ++found;
                return false;
            });
            for (std::size_t t = 0; t < corners.size(); ++t)
                if (rays::blocksExactly({origin}, nullptr, corners[t], glm::dvec4(towards, 0.0))) {
                    EXPECT_TRUE(candidate[t]);
                    ++met;
                }
        }
    }
    EXPECT_GT(met, 2000u);
    EXPECT_LT(found, 40u * 200u * 20u); // a tenth of all
}

TEST(RayTree, EndsWithTheSegment) {
    std::vector<rays::Corners> corners;
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < 100; ++i) {
        const double y = 2.0 + i;
        corners.push_back({glm::dvec3(-1, y, -1), glm::dvec3(1, y, -1), glm::dvec3(0, y, 1)});
        all.push_back(i);
    }
    const rays::RayTree tree(corners, all);
    const auto found = [&](const glm::dvec3& direction, double length) {
        std::size_t count = 0;
        tree.visit(glm::dvec3(0.0), direction, length, [&](std::uint32_t) {
            ++count;
            return false;
        });
        return count;
    };
    EXPECT_EQ(found({0, 1, 0}, infinity), 100u);
    for (const double length : {0.5, 5.0, 12.5}) {
        const auto met = static_cast<std::size_t>(4.0 * length) - 1;
        EXPECT_GE(found({0, 4, 0}, length), met);
        EXPECT_LE(found({0, 4, 0}, length), met + 8); // leaves hold some more
    }
    EXPECT_LE(found({0, -1, 0}, infinity), 8u);
    EXPECT_EQ(found({0, 0, 0}, infinity), 0u);
}

TEST(RayTree, LeavesOutWhatIsNotFinite) {
    std::vector<rays::Corners> corners(
        2, {glm::dvec3(-1, 2, -1), glm::dvec3(1, 2, -1), glm::dvec3(0, 2, 1)});
    corners[0][1].x = infinity;
    const rays::RayTree tree(corners, {0, 1});
    std::vector<std::uint32_t> found;
    tree.visit(glm::dvec3(0.0), {0, 1, 0}, infinity, [&](std::uint32_t triangle) {
        found.push_back(triangle);
        return false;
    });
    EXPECT_EQ(found, std::vector<std::uint32_t>{1});
}

} // namespace
} // namespace edgeshade
