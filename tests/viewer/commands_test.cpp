#include "src/viewer/commands.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

Stage someStage() {
    Stage stage;
    stage.bounds = {{-2, 0, -2}, {2, 2, 2}};
    stage.width = 800;
    stage.height = 600;
    stage.animations = 2;
    return stage;
}

const Stage stage = someStage();

ViewState start() {
    return framed(ViewState(), stage);
}

TEST(Commands, EveryOneChangesTheStateOrIsAtItsEnd) {
    ViewState state = start();
    state.lights = {{{1, 3, 1, 1}}, {{0, 1, 0, 0}}};
    state.camera = orbited(state.camera, 0.4, 0.0);
    for (int c = 0; c <= static_cast<int>(Command::faster); ++c)
        EXPECT_NE(toJson(after(static_cast<Command>(c), state, stage)), toJson(state)) << c;
}

TEST(Commands, AMovedLightKeepsItsRange) {
    ViewState state = start();
    state.lights = {{{1, 3, 1, 1}, 7.5}};
    for (const Command command : {Command::lightLeft, Command::lightUp, Command::lightNearer}) {
        const ViewState moved = after(command, state, stage);
        EXPECT_NE(moved.lights[0].position, state.lights[0].position);
        EXPECT_EQ(moved.lights[0].range, 7.5);
    }
}

TEST(Commands, OppositesCancel) {
    using enum Command;
    const ViewState state = start();
    for (const auto& [one, other] : {std::pair(orbitLeft, orbitRight),
                                     {orbitUp, orbitDown},
                                     {panLeft, panRight},
                                     {panUp, panDown},
                                     {zoomIn, zoomOut}}) {
        const ViewState back = after(other, after(one, state, stage), stage);
        EXPECT_LT(glm::distance(back.camera.from, state.camera.from), 1e-9);
        EXPECT_LT(glm::distance(back.camera.to, state.camera.to), 1e-9);
    }
}

TEST(Commands, FitKeepsTheDirectionAndSeesEverything) {
    ViewState state = start();
    state.camera = {{0.1, 0.9, 0.3}, {0, 1, 0}, 30.0};
    const ViewState fitted = after(Command::fit, state, stage);
    const PictureView view = stage.viewOf(fitted.camera);
    EXPECT_LT(glm::distance(view.forward(), stage.viewOf(state.camera).forward()), 1e-9);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec2 pixel =
            view.pixelOf({corner & 1 ? 2 : -2, corner & 2 ? 2 : 0, corner & 4 ? 2 : -2});
        EXPECT_TRUE(pixel.x > 0 && pixel.x < 800 && pixel.y > 0 && pixel.y < 600);
    }
}

TEST(Commands, ResetGivesTheFirstViewBack) {
    ViewState state = after(Command::addLight, start(), stage);
    state = after(Command::zoomIn, after(Command::orbitLeft, state, stage), stage);
    EXPECT_EQ(toJson(after(Command::reset, state, stage)), toJson(start()));
}

TEST(Commands, LightsComeAndGoButOneStays) {
    ViewState state = start();
    for (std::size_t i = 0; i < mostLights + 9; ++i)
        state = after(Command::addLight, state, stage);
    EXPECT_EQ(state.lights.size(), mostLights);
    EXPECT_EQ(state.chosenLight, mostLights - 1);
    EXPECT_EQ(after(Command::nextLight, state, stage).chosenLight, 0u);
    for (std::size_t i = 0; i < mostLights + 9; ++i)
        state = after(Command::removeLight, state, stage);
    EXPECT_EQ(state.lights.size(), 1u);
    EXPECT_EQ(state.chosenLight, 0u);
}

TEST(Commands, ShadowsOfThePictureOrOfTheRightSide) {
    ViewState state = start();
    EXPECT_EQ(after(Command::nextShadows, state, stage).left.shadows, ShadowMethod::volumes);
    for (const ShadowMethod next :
         {ShadowMethod::volumes, ShadowMethod::primitiveMap, ShadowMethod::map, ShadowMethod::none,
          ShadowMethod::automatic}) {
        state = after(Command::nextShadows, state, stage);
        EXPECT_EQ(state.left.shadows, next);
    }
    state.split = true;
    EXPECT_EQ(after(Command::nextShadows, state, stage).left.shadows, ShadowMethod::automatic);
    EXPECT_EQ(after(Command::nextShadows, state, stage).right.shadows, ShadowMethod::none);
}

TEST(Commands, SpeedAndSplitStayInRange) {
    ViewState state = start();
    for (int i = 0; i < 100; ++i)
        state = after(Command::faster, after(Command::splitRight, state, stage), stage);
    EXPECT_EQ(state.speed, fastest);
    EXPECT_EQ(state.splitAt, 1.0);
    EXPECT_NO_THROW(changed(ViewState(), toJson(state)));
}

} // namespace
} // namespace edgeshade::viewer
