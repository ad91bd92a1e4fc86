#include "src/render/layer_bound.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

Scene stack(int sheets) {
    SceneBuilder builder;
    for (int i = 0; i < sheets; ++i) {
        const float y = 0.01f * static_cast<float>(i);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    return builder.scene();
}

TEST(LayerBound, FewTrianglesNeedNoGroups) {
    const LayerBound bound = boundLayers(stack(100), false, test::pointLight({0, 9, 0}), 255);
    EXPECT_EQ(bound.groupCount, 1u);
    EXPECT_LE(bound.most, 255u);
}

TEST(LayerBound, IsNeverBelowTheTruth) {
    // Straight above, a line meets one triangle of every sheet; along the diagonal two.
    for (const Light& light : {test::pointLight({0.3, 9, 0.1}), test::sun({0.1, 1, 0.2})}) {
        const LayerBound bound = boundLayers(stack(300), false, light, 255);
        EXPECT_GE(bound.most, 300u);
        EXPECT_GT(bound.groupCount, 1u);
        EXPECT_EQ(bound.groupOf.size(), 600u);
    }
}

TEST(LayerBound, SheetsSideBySideAreNoLayers) {
    SceneBuilder builder;
    for (int i = 0; i < 400; ++i) {
        const float x = static_cast<float>(i);
        builder.triangle({x, 0, 0}, {x + 0.9f, 0, 0}, {x, 0, 1});
    }
    for (const Light& light : {test::pointLight({200, 50, 0.1}), test::sun({0.1, 1, 0.2})})
        EXPECT_EQ(boundLayers(builder.scene(), false, light, 255).groupCount, 1u);
}

TEST(LayerBound, ALightAmongTheTrianglesIsBoundedToo) {
    const LayerBound bound =
        boundLayers(stack(1000), false, test::pointLight({0.2, 5.005, 0.1}), 255);
    EXPECT_GE(bound.most, 500u);
    EXPECT_GE(bound.groupCount, 2u);
}

} // namespace
} // namespace edgeshade
