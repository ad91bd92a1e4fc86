#include "preprocess/packing/weld_choice.hpp"

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/pack.hpp"
#include "tests/support/packing.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A box of half size 1 whose six sides are moved outwards by `gap`: twelve edges nearly meet.
GltfBuilder openedBox(float gap) {
    Shape shape = box(glm::vec3(1.0f));
    for (std::size_t i = 0; i < shape.positions.size(); ++i)
        shape.positions[i] += gap * shape.normals[i];
    GltfBuilder gltf;
    gltf.addShapeNode(shape);
    return gltf;
}

WeldChoice chosenFor(const GltfBuilder& gltf) {
    return chooseWeldTolerance(parseGltf(gltf.glb(), "test.glb"), {});
}

} // namespace

TEST(WeldChoice, BordersThatNearlyMeetAreClosed) {
    const WeldChoice choice = chosenFor(openedBox(1e-5f));
    EXPECT_EQ(choice.before.borders, 24u);
    EXPECT_EQ(choice.after.borders, 0u);
    EXPECT_EQ(choice.before.quads, 2 * 6u + 24u); // six diagonals, and borders
    EXPECT_EQ(choice.after.quads, 18u);           // edges of a closed box, one quad each
    EXPECT_GT(choice.tolerance, 1e-5);
    EXPECT_LT(choice.tolerance, 1e-4); // no more than necessary, to within one step
}

TEST(WeldChoice, WhatIsFartherApartThanTheShareStaysOpen) {
    const WeldChoice choice = chosenFor(openedBox(1e-3f)); // for a diagonal of 3.5
    EXPECT_EQ(choice.tolerance, 0.0);
    EXPECT_EQ(choice.after.borders, choice.before.borders);
}

TEST(WeldChoice, WhatIsClosedNeedsNone) {
    EXPECT_EQ(chosenFor(openedBox(0.0f)).tolerance, 0.0);
}

TEST(WeldChoice, NothingIsWeldedThatWouldDegenerateMoreThanItCloses) {
    // Slivers as thin as the gap: welding them would lose their area, and close nothing.
    GltfBuilder gltf = openedBox(1e-5f);
    Shape slivers;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const float x = 0.1f * static_cast<float>(i) - 2.0f;
        slivers.positions.insert(slivers.positions.end(),
                                 {{x, 3, 0}, {x + 1e-6f, 3, 0}, {x, 3, 0.05f}});
        slivers.normals.insert(slivers.normals.end(), 3, glm::vec3(0, 1, 0));
        slivers.texcoords.insert(slivers.texcoords.end(), 3, glm::vec2(0.0f));
        slivers.indices.insert(slivers.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    gltf.addShapeNode(slivers);
    const WeldChoice choice = chosenFor(gltf);
    EXPECT_LE(WeldChoice::harm(choice.before, choice.after),
              WeldChoice::closed(choice.before, choice.after));
    EXPECT_EQ(choice.after.degenerate, choice.before.degenerate);
}

TEST(WeldChoice, APackedFileHasTheToleranceThatWasChosen) {
    const Bytes asset = openedBox(1e-5f).glb();
    CasterSettings chosen;
    chosen.autoWeld = true;
    PackInput input = readForPacking(parseGltf(asset, "test.glb"), chosen, false);
    const Bytes byChoice = packBytes(input, Encoding::indexed);
    ASSERT_TRUE(input.report.weldChoice);
    CasterSettings given;
    given.weldTolerance = input.report.weldChoice->tolerance;
    EXPECT_GT(given.weldTolerance, 0.0);
    EXPECT_EQ(byChoice, packed(asset, Encoding::indexed, given));
    EXPECT_EQ(readShadowHeader(parseGltf(byChoice, "packed.glb"))->settings, given);
    const auto json = toJson(input.report);
    EXPECT_EQ(json["settings"]["weld-tolerance"], given.weldTolerance);
    EXPECT_EQ(json["weld_choice"]["before"]["borders"], 24);
    EXPECT_EQ(json["weld_choice"]["after"]["borders"], 0);
}

} // namespace edgeshade::test
