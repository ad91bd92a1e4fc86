// Proposed silhouettes draw the same pixels as all records, from frame to frame: with lights that
// move, rest and jump, so that lists serve several frames and are rebuilt.
#include "src/gl/headless_context.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::Random;
using test::sun;

constexpr int width = 160, height = 120;

/// The yard, and a box in a mirrored, stretched node.
Scene twoBatches() {
    Scene scene = test::yard().scene();
    glm::dmat4 placed(1.0);
    placed[0] = {-0.6, 0, 0.3, 0};
    placed[1] = {0, 1.7, 0, 0};
    placed[3] = {1.2, 0.4, 1.5, 1};
    Scene second = test::SceneBuilder().box({-1, 0, -1}, {1, 1, 1}).placedBy(placed).scene();
    scene.batches.push_back(second.batches.front());
    return scene;
}

/// One scene on the GPU, drawn with all records and with proposed ones.
class Pair {
  public:
    explicit Pair(SidesLayout layout)
        : loaded_{{}, twoBatches(), {}, {}, {}, {}}, context_({width, height}),
          all_(settingsFor(SilhouetteChoice::all, layout), context_.capabilities()),
          proposed_(settingsFor(SilhouetteChoice::proposed, layout), context_.capabilities()) {
        loaded_.planePairs = buildPlanePairs(loaded_.scene, false);
        scene_.emplace(uploadScene(loaded_, all_.settings().records(), context_.capabilities()));
    }

    void expectSame(const Camera& camera, const std::vector<Light>& lights) {
        const FrameView view = viewOf(camera, lights);
        EXPECT_EQ(draw(proposed_, view), draw(all_, view));
        EXPECT_LE(proposed_.vertexRuns(), all_.vertexRuns());
        FrameView mask = view;
        mask.mask = true;
        EXPECT_EQ(draw(proposed_, mask), draw(all_, mask));
    }

    /// Draws the mask of each light by itself, planned ahead or not.
    std::vector<std::vector<std::uint8_t>>
    drawAlone(const Camera& camera, const std::vector<Light>& lights, bool ahead = false) {
        FrameView view = viewOf(camera, lights);
        view.mask = true;
        for (std::size_t i = 0; ahead && i < lights.size(); ++i) {
            EXPECT_FALSE(proposed_.planAhead(*scene_, aloneView(view, i))) << "it makes lists";
            EXPECT_TRUE(proposed_.planAhead(*scene_, aloneView(view, i))) << "it uploads them";
        }
        madeAhead_ = made();
        std::vector<std::vector<std::uint8_t>> masks;
        runs_.clear();
        for (std::size_t i = 0; i < lights.size(); ++i) {
            masks.push_back(draw(proposed_, aloneView(view, i)));
            runs_.push_back(proposed_.vertexRuns());
        }
        return masks;
    }
    const std::vector<std::size_t>& runs() const { return runs_; } ///< of the last drawAlone()
    std::size_t made() const { return proposed_.volumes()->silhouettes()->made(); }
    std::size_t madeAhead() const { return madeAhead_; } ///< of the last drawAlone()

    const Renderer& proposed() const { return proposed_; }

  private:
    FrameView viewOf(const Camera& camera, const std::vector<Light>& lights) const {
        return test::boundedFrame(
            loaded_.scene, loaded_.settings.castMasked,
            {frustumOf(camera, static_cast<double>(width) / height), width, height, lights, {}});
    }
    static RenderSettings settingsFor(SilhouetteChoice choice, SidesLayout layout) {
        RenderSettings settings;
        settings.silhouette = choice;
        settings.layout = layout;
        return settings;
    }

    std::vector<std::uint8_t> draw(Renderer& renderer, const FrameView& view) {
        renderer.draw(*scene_, view);
        gl::requireNoError("drawing a test scene");
        return context_.readPixels();
    }

    LoadedScene loaded_;
    std::size_t madeAhead_ = 0;
    std::vector<std::size_t> runs_;
    gl::HeadlessContext context_;
    Renderer all_, proposed_;
    std::optional<GpuScene> scene_;
};

Camera around(double angle) {
    return {{7 * std::cos(angle), 3.5, 7 * std::sin(angle)}, {0, 0.5, 0}, 50.0};
}

} // namespace

class ProposedMasks : public testing::TestWithParam<SidesLayout> {};

TEST_P(ProposedMasks, AreThoseOfAllRecordsWhileALightMoves) {
    Pair pair(GetParam());
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.05 * i;
        pair.expectSame(around(0.1 * i), {pointLight({3 * std::cos(angle), 4, 3 * std::sin(angle)}),
                                          sun({std::sin(angle), 1, 0.3})});
    }
    EXPECT_LT(pair.made(), 4u * 80 / 2) << "lists serve for several frames";
}

TEST_P(ProposedMasks, AreMadeOnceForALightAtRest) {
    Pair pair(GetParam());
    pair.expectSame(around(0), {pointLight({2, 4, 1})});
    const std::size_t made = pair.made();
    for (int i = 1; i < 10; ++i)
        pair.expectSame(around(0.3 * i), {pointLight({2, 4, 1})});
    EXPECT_EQ(pair.made(), made);
}

TEST_P(ProposedMasks, AreMadeOnceForEachOfManyLightsThatAreDrawnOneByOne) {
    Pair pair(GetParam());
    std::vector<Light> lights;
    for (int i = 0; i < 24; ++i)
        lights.push_back(pointLight({2 * std::cos(0.2 * i), 4, 2 * std::sin(0.2 * i)}));
    const auto first = pair.drawAlone(around(0), lights);
    const std::size_t made = pair.made();
    EXPECT_GE(made, lights.size());
    for (int i = 1; i < 4; ++i)
        pair.drawAlone(around(0.3 * i), lights);
    EXPECT_EQ(pair.drawAlone(around(0), lights), first);
    EXPECT_EQ(pair.made(), made);
    for (const std::size_t i : {std::size_t{0}, std::size_t{7}, lights.size() - 1}) {
        Pair only(GetParam());
        only.drawAlone(around(0), {lights[i]});
        EXPECT_EQ(pair.runs()[i], only.runs()[0]) << "light " << i << " has lists of its own";
    }
}

TEST_P(ProposedMasks, ArePlannedAhead) {
    const std::vector<Light> lights = {pointLight({2, 4, 1}), sun({0.3, 1, 0.2})};
    Pair ahead(GetParam()), atOnce(GetParam());
    EXPECT_EQ(ahead.drawAlone(around(0), lights, true), atOnce.drawAlone(around(0), lights));
    EXPECT_GT(ahead.madeAhead(), 0u);
    EXPECT_EQ(ahead.made(), ahead.madeAhead()) << "drawing makes no others";
    EXPECT_EQ(atOnce.madeAhead(), 0u);
    EXPECT_EQ(atOnce.made(), ahead.made());
}

TEST_P(ProposedMasks, AreThoseOfAllRecordsWhereverALightJumps) {
    Pair pair(GetParam());
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 at = 5.0 * random.inCube() + glm::dvec3(0, 3, 0);
        // Half of the time on coordinates of faces, where signs are hardest to determine.
        const glm::dvec3 light = random.below(2) ? at : glm::round(at);
        pair.expectSame(around(random.uniform(0, 6)),
                        {random.below(3) ? pointLight(light) : sun(at)});
    }
}

TEST_P(ProposedMasks, AreThoseOfAllRecordsWhereCapsAreDrawn) {
    Pair pair(GetParam());
    Random random(4);
    int withCaps = 0;
    for (int i = 0; i < 60; ++i) {
        // Among the boxes, so that outlines of shadows cross near rectangles.
        const glm::dvec3 eye = 2.0 * random.inCube() + glm::dvec3(0, 1, 0);
        pair.expectSame({eye, eye + random.inCube(), 70.0},
                        {pointLight(3.0 * random.inCube() + glm::dvec3(0, 4, 0))});
        withCaps += pair.proposed().volumes()->capBytes() > 0;
    }
    EXPECT_GT(withCaps, 5);
}

INSTANTIATE_TEST_SUITE_P(Layouts, ProposedMasks,
                         testing::Values(SidesLayout::instanced, SidesLayout::notInstanced));

} // namespace edgeshade
