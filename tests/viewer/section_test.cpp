// Sections in the viewer against pictures of scenes that were cut before they were drawn.

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/gl/headless_context.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/scene/pose.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 160;
constexpr int height = 120;

const Json acrossX = Json::parse(R"({"planes": [[-1, 0, 0, 0.1]]})");
const Json acrossY = Json::parse(R"({"planes": [[0, -1, 0, 0.45]], "shadows": "whole"})");

class SectionInViewer : public testing::Test {
  protected:
    void show(LoadedScene scene) {
        viewer.resize(width, height, 1.0);
        viewer.show(std::move(scene));
        viewer.change({{"show_lights", false}});
        viewer.change(Json::parse(R"({"lights": [[1.5, 6, 2, 1], [-0.3, 1, 0.4, 0]]})"));
    }
    void showYard() { show(test::loadedOf(test::yard().scene())); }

    Pixels picture() {
        viewer.invalidate();
        EXPECT_TRUE(viewer.frame(0.0));
        return context->readPixels();
    }

    /// The same view of a scene that is cut first, in a viewer of its own.
    Pixels cutFirst(LoadedScene scene) const {
        const ViewState& state = viewer.state();
        cutScene(scene, *state.section);
        RenderSettings settings;
        settings.shading = state.shading;
        settings.ambient = state.ambient;
        return test::drawScene(scene.scene, {state.camera, state.lights, width, height}, settings);
    }

    std::unique_ptr<gl::HeadlessContext> context =
        std::make_unique<gl::HeadlessContext>(test::testPicture(width, height));
    Viewer viewer{context->capabilities()};
};

TEST_F(SectionInViewer, DrawsWhatRenderDrawsOfTheCutScene) {
    showYard();
    std::vector<std::pair<Json, Pixels>> drawn;
    for (const Json& section : {acrossX, acrossY}) {
        viewer.change({{"section", section}});
        drawn.emplace_back(section, picture());
    }
    EXPECT_FALSE(drawn[0].second == drawn[1].second);
    // The last ones: their contexts replace the viewer's.
    EXPECT_TRUE(drawn[1].second == cutFirst(test::loadedOf(test::yard().scene())));
}

TEST_F(SectionInViewer, APlaneThatIsMovedAndTakenAwayLeavesTheFirstPicture) {
    showYard();
    const Pixels whole = picture();
    viewer.change({{"section", acrossX}});
    const Pixels cut = picture();
    EXPECT_FALSE(cut == whole);
    viewer.change({{"section", acrossY}});
    EXPECT_FALSE(picture() == cut);
    viewer.change({{"section", acrossX}});
    EXPECT_TRUE(picture() == cut);
    viewer.change({{"section", nullptr}});
    EXPECT_TRUE(picture() == whole);
}

TEST_F(SectionInViewer, ARefusalChangesNothing) {
    showYard();
    viewer.change({{"section", acrossX}});
    const Pixels cut = picture();
    EXPECT_THROW(viewer.change(Json::parse(R"({"section": {"planes": [[0, 0, 0, 1]]}})")), Error);
    EXPECT_THROW(viewer.change({{"section", nullptr}, {"animation", 9}}), Error);
    EXPECT_TRUE(viewer.state().section);
    EXPECT_TRUE(picture() == cut);
}

TEST_F(SectionInViewer, AnotherSceneIsWhole) {
    showYard();
    viewer.change({{"section", acrossX}});
    showYard();
    EXPECT_FALSE(viewer.state().section);
    const Pixels again = picture();
    viewer.change({{"section", acrossX}});
    EXPECT_FALSE(picture() == again);
}

TEST_F(SectionInViewer, ALostContextComesBackCut) {
    showYard();
    viewer.change({{"section", acrossX}});
    const Pixels cut = picture();
    viewer.forgetGpu();
    viewer.change({{"section", acrossY}});
    viewer.change({{"section", acrossX}});
    context.reset();
    context = std::make_unique<gl::HeadlessContext>(test::testPicture(width, height));
    viewer.restoreGpu(context->capabilities());
    EXPECT_TRUE(picture() == cut);
    viewer.forgetGpu();
}

TEST_F(SectionInViewer, TheGroundKeepsItsColourThroughCuts) {
    showYard();
    viewer.change({{"ground", "#804020"}});
    const Pixels whole = picture();
    viewer.change({{"ground", "catcher"}});
    viewer.change({{"section", acrossX}});
    viewer.change({{"ground", "#804020"}});
    const Pixels cut = picture();
    viewer.change({{"section", acrossY}});
    viewer.change({{"section", acrossX}});
    EXPECT_TRUE(picture() == cut);
    viewer.change({{"section", nullptr}});
    EXPECT_TRUE(picture() == whole);
}

LoadedScene loadedOf(const test::GltfBuilder& gltf) {
    LoadedScene made;
    made.document = std::make_shared<const GltfDocument>(parseGltf(gltf.glb(), "moving.glb"));
    made.scene = flattenScene(*made.document, 0.0);
    made.planePairs = buildPlanePairs(made.scene, false);
    return made;
}

class MovingSection : public SectionInViewer, public testing::WithParamInterface<int> {
  protected:
    test::GltfBuilder gltf() const {
        return GetParam() == 0 ? test::walkingFigure(8, 8) : test::morphingBall(12, 10);
    }
};

TEST_P(MovingSection, PosesAreCutAndCutsArePosed) {
    show(loadedOf(gltf()));
    viewer.change({{"ground", "off"}});
    const Pixels start = picture();
    viewer.change({{"section", acrossX}});
    const Pixels cutStart = picture();
    viewer.change({{"time", 0.3}});
    const Pixels then = picture();
    EXPECT_FALSE(then == cutStart);
    viewer.change({{"section", nullptr}});
    viewer.change({{"section", acrossX}});
    EXPECT_TRUE(picture() == then) << "posed, then cut";
    viewer.change({{"time", 0.0}, {"section", nullptr}});
    EXPECT_TRUE(picture() == start) << "and back";
    viewer.change({{"time", 0.3}, {"section", acrossX}});
    EXPECT_TRUE(picture() == then) << "both at once";
}

INSTANTIATE_TEST_SUITE_P(SkinsAndMorphs, MovingSection, testing::Values(0, 1));

TEST_F(SectionInViewer, SoftShadowsAndSmoothingStartAgain) {
    showYard();
    viewer.change(Json::parse(R"({"smooth": 4})"));
    double now = 0.0;
    for (int i = 0; i < 40 && (i == 0 || viewer.smoothing().shown < 4); ++i)
        viewer.frame(now += 1.0);
    ASSERT_EQ(viewer.smoothing().shown, 4u);
    viewer.change({{"section", acrossX}});
    viewer.frame(now);
    EXPECT_EQ(viewer.smoothing().shown, 0u);
}

} // namespace
} // namespace edgeshade::viewer
