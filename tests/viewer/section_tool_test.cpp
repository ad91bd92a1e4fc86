// The section tool: where handles are, how pointers move planes, and its commands.

#include "src/scene/section_text.hpp"
#include "src/viewer/commands.hpp"
#include "src/viewer/interaction.hpp"
#include "src/viewer/section_drawing.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

Stage someStage() {
    Stage stage;
    stage.bounds = {{-2, 0, -3}, {2, 2, 3}};
    stage.width = 800;
    stage.height = 600;
    return stage;
}

const Stage stage = someStage();

ViewState cutAt(const std::vector<glm::dvec4>& planes) {
    ViewState state;
    state.camera = {{7, 6, 9}, {0, 1, 0}, 40.0};
    state.lights = {{{0, 50, 0, 1}}};
    state.section = Section{planes, SectionShadows::cut, {}};
    return state;
}

glm::dvec2 handlePixel(const ViewState& state, std::size_t plane = 0) {
    const auto handles = sectionHandles(*state.section, stage.bounds);
    return stage.viewOf(state.camera).pixelOf(handles[plane].place);
}

Pointer at(const glm::dvec2& pixel) {
    Pointer pointer;
    pointer.x = pixel.x;
    pointer.y = pixel.y;
    return pointer;
}

ViewState dragged(ViewState state, const glm::dvec2& from, const glm::dvec2& to) {
    Interaction interaction;
    state = interaction.down(at(from), state, stage);
    for (const double share : {0.3, 0.7, 1.0})
        if (const auto next = interaction.move(at(from + share * (to - from)), state, stage))
            state = *next;
    interaction.up(at(to));
    return state;
}

TEST(SectionTool, HandlesLieOnTheirPlanesInThePartThatStays) {
    const Section box{sectionBox({0.5, 0.25, -2}, {1.5, 1.5, 2}), SectionShadows::cut, {}};
    const auto handles = sectionHandles(box, stage.bounds);
    ASSERT_EQ(handles.size(), 6u);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        EXPECT_NEAR(glm::length(handles[i].normal), 1.0, 1e-12);
        for (std::size_t k = 0; k < box.planes.size(); ++k) {
            const double distance = glm::dot(box.planes[k], glm::dvec4(handles[i].place, 1.0));
            if (k == i)
                EXPECT_NEAR(distance, 0.0, 1e-9);
            else
                EXPECT_GE(distance, -1e-9) << i << " by " << k;
        }
    }
}

TEST(SectionTool, ADragMovesThePlaneAlongItsNormalByThePointersPath) {
    for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, -3, 0),
                                     glm::dvec3(0, 0, 0.01), glm::dvec3(1, -1, 0.5)}) {
        const glm::dvec4 plane(normal, -glm::dot(normal, glm::dvec3(0.1, 1, 0.2)));
        const ViewState state = cutAt({plane});
        const PictureView view = stage.viewOf(state.camera);
        const SectionHandle handle = sectionHandles(*state.section, stage.bounds).front();
        const double way = 0.4;
        const glm::dvec2 from = view.pixelOf(handle.place);
        const glm::dvec2 to = view.pixelOf(handle.place + way * handle.normal);
        const ViewState moved = dragged(state, from + glm::dvec2(0.0, 0.0), to);
        const glm::dvec4 after = moved.section->planes.front();
        EXPECT_EQ(glm::dvec3(after), normal) << "the normal stays";
        EXPECT_NEAR((plane.w - after.w) / glm::length(normal), way, 1e-6);
        EXPECT_EQ(toJson(moved)["camera"], toJson(state)["camera"]);
        const ViewState back = dragged(moved, to, from);
        EXPECT_NEAR(back.section->planes.front().w, plane.w, 1e-6 * glm::length(normal));
    }
}

TEST(SectionTool, APlaneThatFacesTheEyeGoesAwayAsThePointerGoesUp) {
    ViewState state = cutAt({{0, 0, -1, 0}});
    state.camera = {{0, 1, 9}, {0, 1, 0}, 40.0};
    const glm::dvec2 from = handlePixel(state);
    for (const glm::dvec4& plane : {glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 0, 1, 0)}) {
        state.section->planes = {plane};
        const ViewState up = dragged(state, from, from - glm::dvec2(0, 50));
        EXPECT_LT(sectionHandles(*up.section, stage.bounds).front().place.z, -0.2);
        const ViewState down = dragged(state, from, from + glm::dvec2(0, 50));
        EXPECT_GT(sectionHandles(*down.section, stage.bounds).front().place.z, 0.2);
    }
}

TEST(SectionTool, APlaneStaysWithinReachOfTheScene) {
    const ViewState state = cutAt({{1, 0, 0, 0}});
    const glm::dvec2 from = handlePixel(state);
    for (const double side : {-3000.0, 3000.0}) {
        const ViewState moved = dragged(state, from, from + glm::dvec2(side, 0));
        EXPECT_LT(std::abs(moved.section->planes.front().w), 2.2);
        EXPECT_GT(std::abs(moved.section->planes.front().w), 2.0);
    }
}

TEST(SectionTool, AFingerGrabsDiscAndArrowAndElsewhereItOrbits) {
    ViewState state = cutAt({{1, 0, 0, 0}});
    const PictureView view = stage.viewOf(state.camera);
    const auto handles = sectionHandles(*state.section, stage.bounds);
    const glm::dvec2 middle = view.pixelOf(handles[0].place);
    const glm::dvec2 tip = view.pixelOf(arrowTip(handles[0], view, 1.0));
    EXPECT_GT(glm::distance(middle, tip), 30.0);
    EXPECT_EQ(sectionPlaneAt(handles, middle + glm::dvec2(0, 22), view, 1.0), 0u);
    EXPECT_EQ(sectionPlaneAt(handles, tip, view, 1.0), 0u);
    EXPECT_EQ(sectionPlaneAt(handles, middle + glm::dvec2(0, 60), view, 1.0), std::nullopt);
    const ViewState orbited =
        dragged(state, middle + glm::dvec2(0, 90), middle + glm::dvec2(60, 90));
    EXPECT_EQ(orbited.section, state.section);
    EXPECT_NE(orbited.camera.from, state.camera.from);
    state.showLights = false; // no handles
    EXPECT_EQ(dragged(state, middle, middle + glm::dvec2(60, 0)).section, state.section);
}

TEST(SectionTool, HandlesAreDrawnWhereTheyAreGrabbed) {
    const ViewState state = cutAt({{1, 0, 0, 0}});
    const glm::dvec2 middle = handlePixel(state);
    bool covers = false;
    for (const OverlayVertex& vertex : sectionTriangles(state, stage))
        covers = covers || glm::distance(glm::dvec2(vertex.position), middle) < 0.01;
    EXPECT_TRUE(covers);
    ViewState whole = state;
    whole.section.reset();
    EXPECT_TRUE(sectionTriangles(whole, stage).empty());
}

TEST(SectionTool, PlanesMeetBoxesInPolygons) {
    EXPECT_EQ(planeInBox({1, 0, 0, 0}, stage.bounds).size(), 4u);
    EXPECT_EQ(planeInBox({1, 1, 1, -1}, {{-1, -1, -1}, {1, 1, 1}}).size(), 6u);
    EXPECT_TRUE(planeInBox({1, 0, 0, 9}, stage.bounds).empty());
    EXPECT_TRUE(planeInBox({1, 0, 0, 0}, Box()).empty());
}

TEST(SectionTool, CommandsCutThroughTheMiddleAndAgainMakeWhole) {
    ViewState state = cutAt({{1, 0, 0, 0}});
    state.section.reset();
    for (const Command command : {Command::sectionX, Command::sectionY, Command::sectionZ,
                                  Command::sectionFree, Command::sectionBox}) {
        const ViewState cut = after(command, state, stage);
        ASSERT_TRUE(cut.section);
        for (const glm::dvec4& plane : cut.section->planes) {
            const double middle = glm::dot(plane, glm::dvec4(0, 1, 0, 1));
            const double eye = glm::dot(plane, glm::dvec4(state.camera.from, 1.0));
            if (cut.section->planes.size() == 6) {
                EXPECT_GT(middle, 0.0);
            } else {
                EXPECT_NEAR(middle, 0.0, 1e-9);
                EXPECT_LT(eye, 0.0) << "the eye looks into what stays";
            }
        }
        EXPECT_FALSE(after(command, cut, stage).section);
        EXPECT_FALSE(after(Command::sectionOff, cut, stage).section);
    }
}

TEST(SectionTool, FlipsKeepTheOtherSideAndShadowsTheirMeaning) {
    const ViewState cut = after(Command::sectionX, cutAt({{0, 1, 0, 0}}), stage);
    const ViewState flipped = after(Command::sectionFlip, cut, stage);
    EXPECT_EQ(flipped.section->planes.front(), -cut.section->planes.front());
    EXPECT_EQ(after(Command::sectionFlip, flipped, stage).section, cut.section);
    const ViewState box = after(Command::sectionBox, cut, stage);
    EXPECT_EQ(after(Command::sectionFlip, box, stage).section, box.section);
    const ViewState whole = after(Command::sectionShadows, cut, stage);
    EXPECT_EQ(whole.section->shadows, SectionShadows::whole);
    EXPECT_EQ(after(Command::sectionY, whole, stage).section->shadows, SectionShadows::whole);
    EXPECT_EQ(after(Command::sectionShadows, whole, stage).section, cut.section);
    ViewState none = cut;
    none.section.reset();
    for (const Command command : {Command::sectionFlip, Command::sectionShadows})
        EXPECT_FALSE(after(command, none, stage).section);
}

} // namespace
} // namespace edgeshade::viewer
