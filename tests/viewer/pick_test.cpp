#include "src/viewer/pick.hpp"

#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

TEST(Pick, PassesThroughBacksThatTheSceneCulls) {
    for (const double hand : {1.0, -1.0}) {
        glm::dmat4 placed(1.0);
        placed[0][0] = hand;
        Scene scene = test::SceneBuilder()
                          .box({1, 1, 1}, {-1, -1, -1}) // wound inwards
                          .placedBy(placed)
                          .scene();
        const Ray ray{{0.2, 0.3, 5}, {0, 0, -1}};
        EXPECT_EQ(firstHit(scene, ray)->z, 1.0);
        scene.culls = true;
        EXPECT_EQ(firstHit(scene, ray)->z, -1.0);
        scene.materials[0].doubleSided = true;
        EXPECT_EQ(firstHit(scene, ray)->z, 1.0);
    }
}

} // namespace
} // namespace edgeshade::viewer
