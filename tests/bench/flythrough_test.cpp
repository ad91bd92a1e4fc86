#include "src/bench/flythrough.hpp"

#include <gtest/gtest.h>

namespace edgeshade::bench {
namespace {

const Box box{{-3.0, 0.0, -2.0}, {3.0, 2.0, 2.0}};
constexpr double aspect = 16.0 / 9.0;

void expectEqual(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.from, b.from);
    EXPECT_EQ(a.to, b.to);
    EXPECT_EQ(a.fovDegrees, b.fovDegrees);
}

TEST(Flythrough, IsTheSameEveryTime) {
    const Flythrough once(box, 45.0, aspect), again(box, 45.0, aspect);
    for (int i = 0; i < 120; ++i)
        expectEqual(once.cameraAt(i / 120.0), again.cameraAt(i / 120.0));
}

TEST(Flythrough, EndsWhereItBegan) {
    const Flythrough flight(box, 45.0, aspect);
    expectEqual(flight.cameraAt(0.0), flight.cameraAt(1.0));
}

TEST(Flythrough, BeginsOutsideAndComesInside) {
    const Flythrough flight(box, 45.0, aspect);
    const double radius = 0.5 * box.diagonal();
    EXPECT_GT(glm::distance(flight.cameraAt(0.0).from, box.center()), radius);
    EXPECT_LT(glm::distance(flight.cameraAt(0.5).from, box.center()), radius);
}

TEST(Flythrough, MovesByLittleFromFrameToFrameAndNeverStands) {
    const Flythrough flight(box, 45.0, aspect);
    for (int i = 0; i < 120; ++i) {
        const double step =
            glm::distance(flight.cameraAt(i / 120.0).from, flight.cameraAt((i + 1) / 120.0).from);
        EXPECT_GT(step, 0.0);
        EXPECT_LT(step, 0.1 * box.diagonal());
    }
}

TEST(Flythrough, AScenesWithoutSizeHasOneToo) {
    for (const Box& small : {Box(), Box{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}}}) {
        const Camera camera = Flythrough(small, 45.0, 1.0).cameraAt(0.3);
        EXPECT_GT(glm::distance(camera.from, camera.to), 0.0);
    }
}

TEST(MovedLights, StartWhereTheyStandAndGoElsewhere) {
    const std::vector<Light> lights = {{{1.0, 5.0, 2.0, 1.0}}, {{0.0, 3.0, 0.0, 0.0}}};
    const auto start = movedLights(lights, box, usualCircle, 0.0);
    EXPECT_EQ(start[0].position, lights[0].position);
    EXPECT_EQ(start[1].position, glm::dvec4(0.0, 1.0, 0.0, 0.0)); // the same direction
    glm::dvec4 before[2] = {start[0].position, start[1].position};
    for (int i = 1; i < 120; ++i) {
        const auto moved = movedLights(lights, box, usualCircle, i / 120.0);
        for (std::size_t l = 0; l < 2; ++l) {
            EXPECT_NE(moved[l].position, before[l]) << "a kept shadow map would do";
            EXPECT_EQ(moved[l].position.w, lights[l].position.w);
            before[l] = moved[l].position;
        }
        EXPECT_LE(glm::distance(moved[0].position, lights[0].position), 0.04001 * box.diagonal());
    }
}

} // namespace
} // namespace edgeshade::bench
