// The lights of a viewer that use primitive maps, and when.
#include "src/scene/cut_loaded.hpp"
#include "src/viewer/light_rest.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 160, height = 120;

/// More silhouette edges than volumes are good for.
Scene manyBoxes() {
    test::SceneBuilder builder;
    builder.floor(6.0f);
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 low(-5.0f + 0.5f * static_cast<float>(i % 20), 0.1f,
                            -5.0f + 0.5f * static_cast<float>(i / 20));
        builder.box(low, low + glm::vec3(0.2f, 0.3f, 0.2f));
    }
    return builder.scene();
}

class ViewerMaps : public testing::Test {
  protected:
    ViewerMaps() {
        viewer.resize(width, height, 1.0);
        viewer.show(test::loadedOf(manyBoxes()));
        viewer.change(Json::parse(R"({"show_lights": false, "lights": [[0.4, 1, 0.3, 0]]})"));
    }

    static std::string methodOf(const Viewer& of) { return of.stats().lights.at(0).method; }
    std::string method() const { return methodOf(viewer); }

    /// Draws until the viewer wants no more frames, for at most a minute; advances `now`.
    void settle(Viewer& of) {
        for (int i = 0; i < 6000 && of.wantsFrame(); ++i) {
            now += 0.01;
            if (!of.frame(now)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    void settle() { settle(viewer); }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities()};
    double now = 1.0;
};

/// Builds maps of the scene as read, without a ground, in a task's section, when the test allows
/// it.
class TestWorker : public PrimitiveMapWorker {
  public:
    explicit TestWorker(LoadedScene scene) : scene_(std::move(scene)) {}

    bool works() const override { return working; }
    void ask(const PrimitiveMapTask& task) override {
        ++asked;
        task_ = task;
    }
    void giveUp() override {
        ++givenUp;
        task_.reset();
    }
    std::optional<BuiltPrimitiveMap> take() override {
        if (!mayAnswer || !task_) return std::nullopt;
        cutScene(scene_, task_->section.value_or(Section()));
        PrimitiveMapJob job(scene_, *task_, {});
        job.finish();
        task_.reset();
        return job.built();
    }

    bool working = true, mayAnswer = false;
    int asked = 0, givenUp = 0;

  private:
    LoadedScene scene_;
    std::optional<PrimitiveMapTask> task_;
};

std::size_t differing(const Pixels& a, const Pixels& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4)
        count += std::abs(a[i] - b[i]) > 2 || std::abs(a[i + 1] - b[i + 1]) > 2;
    return count;
}

TEST_F(ViewerMaps, PanesAreInShadowOnceTheLightRestsWhereVolumesAreCounted) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    test::SceneBuilder builder;
    builder.floor(6.0f).box({-2, 3, -2}, {2, 3.2f, 2});
    Material pane;
    pane.alphaMode = AlphaMode::blend;
    pane.doubleSided = true;
    pane.metallic = 0.0f;
    pane.baseColorFactor.a = 0.8f;
    builder.material(pane).quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1});
    viewer.show(test::loadedOf(builder.scene()));
    viewer.change(Json::parse(R"({"show_lights": false, "lights": [[0.1, 1, 0.1, 0]],
        "left": {"shadows": "volumes"},
        "camera": {"from": [0, 2.2, 6], "to": [0, 1, 0], "fov": 40}})"));
    viewer.frame(now);
    const Pixels moving = context.readPixels();
    settle();
    EXPECT_EQ(method(), "volumes");
    EXPECT_GT(differing(moving, context.readPixels()), 50u);
}

TEST_F(ViewerMaps, AGroundThatIsNotSeenTakesNoRoomInThem) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    settle();
    const std::size_t without = viewer.stats().primitiveMapBytes;
    viewer.change({{"ground", "catcher"}});
    EXPECT_EQ(method(), "volumes") << "a map for other receivers";
    settle();
    EXPECT_EQ(method(), "primitive-map");
    EXPECT_GT(viewer.stats().primitiveMapBytes, without + without / 20);
    viewer.change({{"ground", "off"}});
    settle();
    EXPECT_EQ(viewer.stats().primitiveMapBytes, without);
}

TEST_F(ViewerMaps, ALightIsCountedWhileItMovesAndLookedUpOnceItRests) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    viewer.frame(now);
    EXPECT_EQ(method(), "volumes");
    const Pixels counted = context.readPixels();
    viewer.frame(now + 0.9 * LightRest::enough);
    EXPECT_EQ(method(), "volumes");
    settle();
    EXPECT_EQ(method(), "primitive-map");
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_GT(viewer.stats().primitiveMapBytes, 0u);
    // The same picture, except for pixels that boundaries cross.
    EXPECT_LT(differing(context.readPixels(), counted), 20u);

    viewer.change(Json::parse(R"({"lights": [[0.5, 1, 0.3, 0]]})"));
    EXPECT_TRUE(viewer.frame(now += 0.01));
    EXPECT_EQ(method(), "volumes");
    EXPECT_EQ(viewer.stats().primitiveMapBytes, 0u); // the old one is gone
    settle();
    EXPECT_EQ(method(), "primitive-map");
}

TEST_F(ViewerMaps, AWorkerBuildsThemWhereThereIsOne) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    settle();
    const Pixels byItself = context.readPixels();

    const auto worker = std::make_shared<TestWorker>(test::loadedOf(manyBoxes()));
    ViewerSettings settings;
    settings.mapWorker = worker;
    Viewer helped(context.capabilities(), settings);
    helped.resize(width, height, 1.0);
    helped.show(test::loadedOf(manyBoxes()));
    const auto move = [&](double x) {
        helped.change({{"show_lights", false}, {"lights", {{x, 1, 0.3, 0}}}});
    };
    const auto wait = [&] {
        for (int i = 0; i < 100; ++i)
            helped.frame(now += 0.01);
    };
    move(0.1);
    wait();
    EXPECT_EQ(methodOf(helped), "volumes") << "it has no answer yet";
    EXPECT_TRUE(helped.wantsFrame());
    EXPECT_EQ(worker->asked, 1);
    EXPECT_EQ(worker->givenUp, 0);
    move(0.4);
    wait();
    EXPECT_EQ(worker->asked, 2) << "for another light";
    EXPECT_EQ(worker->givenUp, 1);
    worker->mayAnswer = true;
    settle(helped);
    EXPECT_EQ(methodOf(helped), "primitive-map");
    EXPECT_EQ(worker->asked, 2);
    EXPECT_EQ(context.readPixels(), byItself);

    worker->mayAnswer = false;
    move(0.2);
    wait();
    helped.show(test::loadedOf(manyBoxes()));
    EXPECT_EQ(worker->givenUp, 2) << "another scene's is of no use";

    move(0.4);
    wait();
    worker->working = false;
    settle(helped);
    EXPECT_EQ(methodOf(helped), "primitive-map") << "by itself";
    EXPECT_EQ(worker->asked, 4);
}

TEST_F(ViewerMaps, AWorkerCutsTheSceneThatItKnowsAndBuildsItsMap) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    const auto worker = std::make_shared<TestWorker>(test::loadedOf(manyBoxes()));
    worker->mayAnswer = true;
    ViewerSettings settings;
    settings.mapWorker = worker;
    Viewer helped(context.capabilities(), settings);
    helped.resize(width, height, 1.0);
    helped.show(test::loadedOf(manyBoxes()));
    int asked = 0;
    for (const char* section :
         {R"({"planes": [[0.3, -1, 0.1, 0.2]]})", R"({"planes": [[-1, 0.1, 0, 1]]})",
          R"({"planes": [[0, -1, 0, 0.2], [1, 0, 0, 2]], "shadows": "whole"})", "null"}) {
        SCOPED_TRACE(section);
        Pixels pictures[2];
        for (Viewer* const of : {&viewer, &helped}) {
            of->change({{"show_lights", false},
                        {"lights", {{0.4, 1, 0.3, 0}}},
                        {"left", {{"shadows", "lookup"}}},
                        {"section", Json::parse(section)}});
            settle(*of);
            EXPECT_EQ(methodOf(*of), "primitive-map");
            pictures[of == &helped] = context.readPixels();
        }
        EXPECT_EQ(worker->asked, ++asked);
        EXPECT_TRUE(pictures[0] == pictures[1]);
    }
}

TEST_F(ViewerMaps, ALightThatIsDraggedGetsNone) {
    for (int i = 0; i < 30; ++i) {
        viewer.change({{"lights", {{0.4 + 0.01 * i, 1, 0.3, 0}}}});
        viewer.frame(now += 0.1);
        EXPECT_EQ(method(), "volumes");
    }
}

TEST_F(ViewerMaps, ALostContextTakesItsMapAlong) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    settle();
    EXPECT_EQ(method(), "primitive-map");
    viewer.forgetGpu();
    viewer.restoreGpu(context.capabilities());
    EXPECT_TRUE(viewer.frame(now += 0.01));
    EXPECT_EQ(method(), "volumes");
    settle();
    EXPECT_EQ(method(), "primitive-map");
}

TEST_F(ViewerMaps, AnotherSceneStopsWhatIsBeingBuilt) {
    viewer.frame(now);
    viewer.frame(now += 1.0); // starts building
    viewer.show(test::loadedOf(test::yard().scene()));
    settle();
    EXPECT_EQ(method(), "volumes");
}

TEST_F(ViewerMaps, AnAnimationThatPlaysLeavesTheMapOfWhatRests) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "no float textures";
    Scene scene = manyBoxes();
    Scene moving = test::SceneBuilder().box({-1, 2, -1}, {1, 2.3f, 1}).scene();
    moving.batches[0].node = 0;
    scene.batches.push_back(moving.batches[0]);
    viewer.show(test::loadedOf(scene));
    viewer.change(Json::parse(R"({"show_lights": false, "lights": [[0.4, 1, 0.3, 0]]})"));
    viewer.frame(now += 0.01);
    const Pixels counted = context.readPixels();
    settle();
    EXPECT_EQ(method(), "primitive-map");
    EXPECT_LT(differing(context.readPixels(), counted), 20u);
}

TEST_F(ViewerMaps, FewSilhouettesAreCounted) {
    viewer.show(test::loadedOf(test::yard().scene()));
    viewer.frame(now);
    EXPECT_FALSE(viewer.wantsFrame()); // nothing to wait for
    EXPECT_EQ(method(), "volumes");
}

TEST_F(ViewerMaps, ShadowVolumesCanBeShownAllTheSame) {
    settle();
    const Pixels plain = context.readPixels();
    viewer.change({{"debug", "volumes"}});
    viewer.frame(now += 0.01);
    EXPECT_GT(differing(context.readPixels(), plain), 100u);
}

TEST_F(ViewerMaps, ListsLongerThanLoopsGoAreNotAsked) {
    test::SceneBuilder builder;
    builder.floor(4);
    for (int i = 0; i < 3200; ++i) {
        const float y = 0.5f + 1e-4f * static_cast<float>(i);
        builder.quad({-0.5f, y, 0.5f}, {0.5f, y, 0.5f}, {0.5f, y, -0.5f}, {-0.5f, y, -0.5f});
    }
    viewer.show(test::loadedOf(builder.scene()));
    viewer.change(Json::parse(R"({"left": {"shadows": "primitive-map"}, "light_samples": 4,
        "lights": [{"direction": [0.4, 1, 0.3], "angle": 2}]})"));
    settle();
    EXPECT_EQ(method(), "volumes");
    if (context.capabilities().limits == gl::Limits::device) {
        EXPECT_NE(viewer.stats().lights.at(0).why.find("more than a shader loop can test"),
                  std::string::npos)
            << viewer.stats().lights.at(0).why;
    }
}

TEST(LightRest, IsWhatStaysLongEnough) {
    LightRest rest;
    const Light a = test::sun({0, 1, 0}), b = test::pointLight({1, 2, 3});
    rest.see({a}, 1.0);
    EXPECT_FALSE(rest.rests(a, 1.0));
    rest.see({a, b}, 1.4);
    EXPECT_TRUE(rest.rests(a, 1.0 + LightRest::enough));
    EXPECT_FALSE(rest.rests(b, 1.0 + LightRest::enough));
    rest.see({b}, 1.5);
    EXPECT_FALSE(rest.rests(a, 9.0));
    rest.clear();
    EXPECT_FALSE(rest.rests(b, 9.0));
    Light larger = b;
    larger.extent = LightExtent{};
    rest.see({b}, 10.0);
    rest.see({larger}, 11.0);
    EXPECT_FALSE(rest.rests(larger, 11.0));
    EXPECT_TRUE(rest.rests(larger, 11.0 + LightRest::enough));
}

} // namespace
} // namespace edgeshade::viewer
