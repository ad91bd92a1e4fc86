// When a light touches a triangle, and when it grazes it (docs/method.md, C47).
#include "src/shadow/lights/light_contact.hpp"
#include "tests/support/hard_lights.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;
using Corners = std::array<glm::dvec3, 3>;

Corners rounded(const Corners& exact) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = glm::dvec3(glm::vec3(exact[i]));
    return corners;
}

glm::dvec3 within(const Corners& of, double u, double v) {
    return of[0] + u * (of[1] - of[0]) + v * (of[2] - of[0]);
}

/// A triangle without small angles.
Corners someTriangle(Random& random, double size, double away) {
    const glm::dvec3 middle = away * random.inCube();
    for (;;) {
        const Corners corners = {middle + size * random.inCube(), middle + size * random.inCube(),
                                 middle + size * random.inCube()};
        const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
        if (glm::length(glm::cross(ab, ac)) > 0.2 * glm::length(ab) * glm::length(ac))
            return corners;
    }
}

glm::dvec3 normalOf(const Corners& of) {
    return glm::normalize(glm::cross(of[1] - of[0], of[2] - of[0]));
}

TEST(LightContact, TouchesWhatItIsMeantToLieOnHoweverThatIsRounded) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const double size = random.magnitude(-3, 3);
        const Corners exact = someTriangle(random, size, size * random.magnitude(-2, 3));
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const std::array<glm::dvec3, 4> places = {exact[0], within(exact, 0.5, 0.5),
                                                  within(exact, u, 0), within(exact, u, v)};
        const glm::dvec3& place = places[static_cast<std::size_t>(i % 4)];
        const LightContact contact = contactOf(rounded(exact), glm::dvec4(place, 1.0));
        EXPECT_TRUE(contact.touches) << i;
        EXPECT_TRUE(contact.grazes);
        EXPECT_GT(contact.reach, 0.0);
    }
}

TEST(LightContact, ReachesNoFartherThanRounding) {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const double size = random.magnitude(-3, 3), away = random.magnitude(-2, 3);
        const Corners corners = rounded(someTriangle(random, size, size * away));
        const double hair = 1e-5 * size * std::max(1.0, away);
        const glm::dvec3 place =
            within(corners, 0.3, 0.3) + (i % 2 == 0 ? hair : -hair) * normalOf(corners);
        EXPECT_FALSE(contactOf(corners, glm::dvec4(place, 1.0)).touches) << i;
    }
}

/// Float arithmetic as a device may do it: in any order, fused or not.
double onDevice(const glm::vec4& plane, const glm::vec4& light, int order) {
    const std::array<float, 4> terms = {plane.x * light.x, plane.y * light.y, plane.z * light.z,
                                        plane.w * light.w};
    switch (order) {
    case 0:
        return ((terms[0] + terms[1]) + terms[2]) + terms[3];
    case 1:
        return (terms[0] + terms[3]) + (terms[1] + terms[2]);
    default:
        return std::fma(plane.x, light.x,
                        std::fma(plane.y, light.y, std::fma(plane.z, light.z, terms[3])));
    }
}

/// For a light on or next to a triangle every device finds either 0 or the right sign.
TEST(LightContact, LeavesNoSignToRounding) {
    Random random(3);
    int touching = 0, near = 0;
    for (int i = 0; i < 60'000; ++i) {
        const double size = random.magnitude(-1, 1);
        const Corners corners = rounded(someTriangle(random, size, size * random.magnitude(-1, 2)));
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const glm::dvec3 normal = normalOf(corners);
        const glm::dvec3 place = within(corners, u, v) + size * random.magnitude(-9, -4) *
                                                             (i % 2 == 0 ? 1.0 : -1.0) * normal;
        const LightContact contact = contactOf(corners, glm::dvec4(place, 1.0));
        const glm::vec4 plane(glm::dvec4(normal, -glm::dot(normal, corners[0])));
        const double side = onDevice(plane, glm::vec4(glm::vec3(place), 1.0f), i % 3);
        const double height = glm::dot(normal, place - corners[0]);
        if (contact.touches) {
            EXPECT_LE(std::abs(side), contact.reach) << i;
            ++touching;
        } else {
            EXPECT_GT(side * height, 0.0) << i;
            ++near;
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(near, 1000);
}

TEST(LightContact, GrazesFromWithinTwoSecondsOfArc) {
    const Corners wall = {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}};
    for (const double angle : {0.0, 0.9e-5, -0.9e-5})
        EXPECT_TRUE(contactOf(wall, {0.3, 1.0, 1.0440306508910551 * angle, 0.0}).grazes) << angle;
    for (const double angle : {1.1e-5, -1.1e-5, 0.1})
        EXPECT_FALSE(contactOf(wall, {0.3, 1.0, 1.05 * angle, 0.0}).grazes) << angle;
    EXPECT_FALSE(contactOf(wall, {0.3, 1.0, 0.0, 0.0}).touches);
    // A lamp beside the wall in its plane, and one in front of it at a tiny distance.
    EXPECT_TRUE(contactOf(wall, {10, 1, 1e-6, 1}).grazes);
    EXPECT_FALSE(contactOf(wall, {10, 1, 1e-6, 1}).touches);
    EXPECT_FALSE(contactOf(wall, {1, 1, 1e-5, 1}).grazes);
    EXPECT_FALSE(contactOf(wall, {10, 1, 1e-3, 1}).grazes);
}

TEST(LightContact, HasNothingToDoWithWhatHasNoArea) {
    const Corners line = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
    EXPECT_FALSE(contactOf(line, {1, 1, 1, 1}).grazes);
    EXPECT_FALSE(contactOf(line, {1, 1, 1, 0}).grazes);
}

TEST(LightContact, IsFoundInAMesh) {
    const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 1, 3};
    EXPECT_GT(contactReachOf(positions, indices, {0.5, 0, 0, 1}), 0.0);
    EXPECT_GT(contactReachOf(positions, indices, {0.2, 0, 0.2, 1}), 0.0);
    EXPECT_EQ(contactReachOf(positions, indices, {0.5, -0.1, 0, 1}), 0.0);
    EXPECT_EQ(contactReachOf(positions, indices, {0.5, 0, 0, 0}), 0.0);
}

} // namespace
} // namespace edgeshade
