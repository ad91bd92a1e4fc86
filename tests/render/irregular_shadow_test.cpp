// Drawn shadows whose visible points are tested one by one (docs/method.md, C46): they match those
// of volumes; and the cases in which they replace volumes.
#include "preprocess/base/error.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <GLES2/gl2.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::yard;

constexpr int width = 121, height = 83;

RenderSettings byPoints(Shading shading = Shading::base) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::irregularZBuffer;
    settings.shading = shading;
    return settings;
}

RenderSettings byVolumes(Shading shading = Shading::base) {
    RenderSettings settings;
    settings.shading = shading;
    return settings;
}

class IrregularShadows : public testing::Test {
  protected:
    void SetUp() override {
        if (!test::canAskPoints())
            GTEST_SKIP() << "no processor draws, or not into framebuffers with depth";
    }
};

/// Number of pixels that differ by more than rounding.
std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        bool differs = false;
        for (std::size_t c = i; c < i + 4; ++c)
            differs = differs || std::abs(a[c] - b[c]) > 2;
        count += differs;
    }
    return count;
}

void expectAlike(const Scene& scene, const test::TestView& view, Shading shading) {
    const auto volumes = test::drawScene(scene, view, byVolumes(shading));
    RenderSettings none = byVolumes(shading);
    none.shadows = ShadowMethod::none;
    const auto lit = test::drawScene(scene, view, none);
    EXPECT_GT(differing(volumes, lit), 50u) << "there should be shadows";
    // At boundaries points may be on either side.
    EXPECT_LE(differing(test::drawScene(scene, view, byPoints(shading)), volumes), 8u);
}

test::TestView corner(const std::vector<Light>& lights) {
    return {{{5, 4, 6}, {0, 0.5, 0}, 50.0}, lights, width, height};
}

TEST_F(IrregularShadows, AreThoseOfVolumes) {
    Light ranged = pointLight({1, 3, 1});
    ranged.range = 4.0;
    const std::vector<std::vector<Light>> all = {{sun({0.4, 1, 0.3})},
                                                 {pointLight({0.3, 4, 0.7})},
                                                 {ranged},
                                                 {sun({-0.6, 0.5, 0.2}), pointLight({1, 2, 2})}};
    for (const std::vector<Light>& lights : all)
        for (const Shading shading : {Shading::base, Shading::full}) {
            SCOPED_TRACE(lights.size());
            expectAlike(yard().scene(), corner(lights), shading);
        }
}

TEST_F(IrregularShadows, AreThoseOfVolumesInDepthSlices) {
    test::TestView view = corner({pointLight({0.3, 4, 0.7})});
    view.depth.slices = 3;
    expectAlike(yard().scene(), view, Shading::base);
}

TEST_F(IrregularShadows, AreThoseOfVolumesWhereBatchesAreMoved) {
    expectAlike(yard()
                    .placedBy(glm::scale(glm::translate(glm::dmat4(1.0), {0.2, 0.1, -0.3}),
                                         {-1.1, 0.9, 1.2}))
                    .scene(),
                corner({pointLight({0.3, 4, 0.7})}), Shading::base);
}

/// A scene in its own context, drawn as often as needed.
class Drawing {
  public:
    Drawing(const Scene& scene, const RenderSettings& settings, int samples = 0)
        : context_(test::testPicture(width, height, samples)),
          renderer_(suited(settings, context_.capabilities()), context_.capabilities()),
          loaded_(test::loadedOf(scene)),
          scene_(uploadScene(loaded_, renderer_.settings().records(), context_.capabilities())) {}

    std::vector<std::uint8_t> draw(const Light& light, bool atRest = false) {
        FrameRequest request;
        request.frustum =
            frustumOf({{5, 4, 6}, {0, 0.5, 0}, 50.0}, static_cast<double>(width) / height);
        request.width = width;
        request.height = height;
        request.lights = {light};
        FrameView view = test::boundedFrame(loaded_.scene, false, request);
        view.lights.front().atRest = atRest;
        prepareScene(scene_, loaded_, view, renderer_);
        renderer_.draw(scene_, view);
        methods_ = lightMethods(scene_, view, renderer_);
        gl::requireNoError("drawing");
        return context_.readPixels();
    }
    /// The method of the last frame's light.
    const LightMethod& method() const { return methods_.front(); }
    GpuScene& scene() { return scene_; }
    const gl::HeadlessContext& context() const { return context_; }

  private:
    static RenderSettings suited(RenderSettings settings, const gl::Capabilities& capabilities) {
        settings.layout = bestLayout(capabilities);
        return settings;
    }

    gl::HeadlessContext context_;
    Renderer renderer_;
    LoadedScene loaded_;
    GpuScene scene_;
    std::vector<LightMethod> methods_;
};

/// This many boxes of twelve triangles above a floor.
Scene boxes(int count) {
    SceneBuilder builder;
    builder.floor(6);
    for (int i = 0; i < count; ++i) {
        const auto at = [&](int by) { return 0.004f * static_cast<float>(i / by % 31); };
        const glm::vec3 low(-2.0f + 30.0f * at(1), 0.2f + 10.0f * at(31), -1.0f);
        builder.box(low, low + glm::vec3(0.05f));
    }
    return builder.scene();
}

RenderSettings automatic() {
    RenderSettings settings;
    settings.shadows = ShadowMethod::automatic;
    return settings;
}

TEST_F(IrregularShadows, AreDrawnOfManyCastersWhereALightMovesAndTheProcessorDraws) {
    const Light lamp = pointLight({1, 4, 2});
    const auto volumes = Drawing(boxes(700), byVolumes()).draw(lamp);
    {
        Drawing few(boxes(20), automatic());
        few.draw(lamp);
        EXPECT_EQ(few.method().method, "volumes");
    }
    Drawing many(boxes(700), automatic());
    EXPECT_LE(differing(many.draw(lamp), volumes), 8u);
    EXPECT_EQ(many.method().method, "irregular-z-buffer");
    EXPECT_FALSE(many.method().why.empty());
    many.draw(lamp, true);
    if (test::testLimits() == gl::Limits::device) {
        EXPECT_EQ(many.method().method, "primitive-map");
    }
}

TEST_F(IrregularShadows, FollowWhatMoves) {
    Drawing drawing(yard().scene(), byPoints());
    drawing.draw(sun({0.4, 1, 0.3}));
    const glm::dmat4 aside = glm::translate(glm::dmat4(1.0), {0.5, 0.0, 0.2});
    drawing.scene().batches.front().worldFromBatch = aside;
    const auto moved = drawing.draw(sun({0.4, 1, 0.3}));
    Drawing afresh(yard().scene(), byPoints());
    afresh.scene().batches.front().worldFromBatch = aside;
    EXPECT_EQ(moved, afresh.draw(sun({0.4, 1, 0.3})));
}

TEST_F(IrregularShadows, AreRefusedWhereTrianglesCantBeNumbered) {
    std::optional<Drawing> several;
    try {
        several.emplace(yard().scene(), byPoints(), 4);
    } catch (const Error&) {
        GTEST_SKIP() << "this GL has no pictures of several samples";
    }
    Drawing& drawing = *several;
    GLint sampled = 0;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &sampled);
    if (sampled == 0) GTEST_SKIP() << "Mesa's pbuffers have one sample";
    EXPECT_THROW(drawing.draw(sun({0.4, 1, 0.3})), Error);
    gl::Capabilities without = drawing.context().capabilities();
    without.extensions.clear();
    EXPECT_THROW(Renderer(byPoints(), without), Error);
    EXPECT_NO_THROW(Renderer(automatic(), without));
}

} // namespace
} // namespace edgeshade
