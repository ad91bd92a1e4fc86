// From pointers to motions, and from motions to states.

#include "src/viewer/interaction.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

/// A box of 4 x 2 x 4, with no surface on any ray.
Stage emptyStage() {
    Stage stage;
    stage.bounds = {{-2, 0, -2}, {2, 2, 2}};
    stage.width = 800;
    stage.height = 600;
    return stage;
}

const Stage stage = emptyStage();

ViewState someState() {
    ViewState state;
    state.camera = {{0, 1, 8}, {0, 1, 0}, 45.0};
    state.lights = {{{0.5, 2, 1, 1}}};
    return state;
}

Pointer pointer(double x, double y, int id = 0) {
    Pointer result;
    result.id = id;
    result.x = x;
    result.y = y;
    return result;
}

/// The state after a drag from one place to another.
ViewState dragged(Pointer from, double x, double y, const ViewState& start = someState()) {
    Interaction interaction;
    ViewState state = interaction.down(from, start, stage);
    from.x = x;
    from.y = y;
    state = interaction.move(from, state, stage).value_or(state);
    interaction.up(from);
    EXPECT_FALSE(interaction.move(from, state, stage));
    return state;
}

TEST(Gestures, OnlyPointersThatAreDownMove) {
    Gestures gestures;
    EXPECT_FALSE(gestures.move(pointer(1, 2)));
    gestures.down(pointer(1, 2));
    const auto motion = gestures.move(pointer(4, 6));
    ASSERT_TRUE(motion);
    EXPECT_FALSE(motion->pinch);
    EXPECT_EQ(motion->to - motion->from, glm::dvec2(3, 4));
    gestures.up(pointer(4, 6));
    EXPECT_EQ(gestures.count(), 0u);
}

TEST(Gestures, TwoFingersPinchAroundTheirMiddle) {
    Gestures gestures;
    gestures.down(pointer(100, 100, 1));
    gestures.down(pointer(200, 100, 2));
    const auto motion = gestures.move(pointer(300, 100, 2));
    ASSERT_TRUE(motion);
    EXPECT_TRUE(motion->pinch);
    EXPECT_DOUBLE_EQ(motion->spread, 2.0);
    EXPECT_EQ(motion->from, glm::dvec2(150, 100));
    EXPECT_EQ(motion->to, glm::dvec2(200, 100));
}

TEST(Gestures, AThirdFingerDoesNothing) {
    Gestures gestures;
    for (int id = 0; id < 3; ++id)
        gestures.down(pointer(100.0 * id, 0, id));
    EXPECT_FALSE(gestures.move(pointer(500, 500, 2)));
    EXPECT_TRUE(gestures.move(pointer(1, 1, 0)));
}

TEST(Interaction, DraggingOrbits) {
    const ViewState state = dragged(pointer(100, 500), 50, 520);
    EXPECT_GT(state.camera.from.x, 0.0); // the scene moves left, the eye right
    EXPECT_GT(state.camera.from.y, 1.0);
    EXPECT_EQ(state.camera.to, someState().camera.to);
}

TEST(Interaction, ShiftOrAnotherButtonPans) {
    Pointer shift = pointer(100, 500);
    shift.shift = true;
    Pointer middle = pointer(100, 500);
    middle.button = PointerButton::middle;
    Pointer secondary = pointer(100, 500);
    secondary.button = PointerButton::secondary;
    for (const Pointer& from : {shift, middle, secondary}) {
        const ViewState state = dragged(from, 150, 500);
        const PictureView view = stage.viewOf(state.camera);
        EXPECT_LT(glm::distance(view.pixelOf({0, 1, 0}), glm::dvec2(450, 300)), 1e-6);
    }
}

TEST(Interaction, AHandleIsDraggedToThePointer) {
    ViewState start = someState();
    start.lights.push_back({{-1, 1, 0, 1}});
    const glm::dvec2 handle = *stage.handles().pixelOf(start.lights[1], stage.viewOf(start.camera));
    const ViewState state = dragged(pointer(handle.x, handle.y), 600, 200, start);
    EXPECT_EQ(state.chosenLight, 1u);
    EXPECT_EQ(state.camera.from, start.camera.from);
    EXPECT_LT(glm::distance(*stage.handles().pixelOf(state.lights[1], stage.viewOf(state.camera)),
                            glm::dvec2(600, 200)),
              1e-6);
    start.showLights = false;
    EXPECT_EQ(dragged(pointer(handle.x, handle.y), 600, 200, start).lights[1].position,
              start.lights[1].position);
}

TEST(Interaction, ControlMovesTheChosenLightFromAnywhere) {
    Pointer from = pointer(20, 20);
    from.control = true;
    const ViewState start = someState();
    const ViewState state = dragged(from, 60, 30, start);
    const PictureView view = stage.viewOf(start.camera);
    EXPECT_LT(glm::distance(*stage.handles().pixelOf(state.lights[0], view),
                            *stage.handles().pixelOf(start.lights[0], view) + glm::dvec2(40, 10)),
              1e-6);
}

TEST(Interaction, TheSplitsLineIsDragged) {
    ViewState start = someState();
    start.split = true;
    EXPECT_DOUBLE_EQ(dragged(pointer(403, 500), 200, 480, start).splitAt, 0.25);
    EXPECT_DOUBLE_EQ(dragged(pointer(403, 500), -50, 480, start).splitAt, 0.0);
    start.split = false;
    EXPECT_DOUBLE_EQ(dragged(pointer(403, 500), 200, 480, start).splitAt, 0.5);
}

TEST(Interaction, WhatIsBetweenTwoFingersStaysThere) {
    Interaction interaction;
    ViewState state = interaction.down(pointer(100, 500, 1), someState(), stage);
    state = interaction.down(pointer(300, 500, 2), state, stage);
    const glm::dvec3 held = stage.viewOf(state.camera).pointAt({200, 500}, 8.0);
    state = *interaction.move(pointer(500, 400, 2), state, stage);
    const PictureView view = stage.viewOf(state.camera);
    EXPECT_LT(glm::distance(view.pixelOf(held), glm::dvec2(300, 450)), 1e-6);
    EXPECT_LT(glm::distance(state.camera.from, state.camera.to), 8.0);
    // The remaining finger continues to orbit.
    interaction.up(pointer(500, 400, 2));
    const Camera before = state.camera;
    state = *interaction.move(pointer(110, 500, 1), state, stage);
    EXPECT_EQ(state.camera.to, before.to);
    EXPECT_NE(state.camera.from, before.from);
}

TEST(Interaction, TheWheelZoomsToTheSurfaceUnderThePointer) {
    Stage walled = emptyStage();
    const glm::dvec3 seen(0.5, 1.5, 2.0);
    walled.firstHit = [&](const Ray&) { return seen; };
    const ViewState start = someState();
    const glm::dvec2 pixel = walled.viewOf(start.camera).pixelOf(seen);
    const ViewState state = Interaction().wheel(pixel, 3.0, start, walled);
    EXPECT_LT(glm::distance(state.camera.from, seen), glm::distance(start.camera.from, seen));
    EXPECT_LT(glm::distance(walled.viewOf(state.camera).pixelOf(seen), pixel), 1e-6);
    const ViewState back = Interaction().wheel(pixel, -3.0, state, walled);
    EXPECT_LT(glm::distance(back.camera.from, start.camera.from), 1e-9);
}

} // namespace
} // namespace edgeshade::viewer
