// What is in shadow takes the colours that ambient light leaves, which were drawn beside those in
// light (AmbientTarget): the same pictures as of surfaces that are drawn again.
#include "preprocess/base/error.hpp"
#include "preprocess/scene/ground.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <GLES2/gl2.h>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;

constexpr int width = 121, height = 83;

RenderSettings full(AmbientTargetChoice choice) {
    RenderSettings settings;
    settings.shading = Shading::full;
    settings.ambientTarget = choice;
    return settings;
}

gl::Capabilities capabilities() {
    return gl::HeadlessContext(test::testPicture(1, 1)).capabilities();
}

bool isPossible() {
    return capabilities().drawBuffers.has_value();
}

/// Pixels where edges pass a centre, which fall the other way where rows lie the other way.
std::size_t mostTies() {
    return capabilities().framebufferFlip ? 0 : 4;
}

/// Boxes of all kinds of materials above a floor, one of them seen through.
Scene display(bool ground) {
    SceneBuilder builder;
    Material metal;
    metal.roughness = 0.3f;
    metal.baseColorFactor = {0.9f, 0.6f, 0.2f, 1.0f};
    builder.material(metal).floor(6).box({-2, 0.2f, -1}, {-1, 1.4f, 0});
    Material coated;
    coated.metallic = 0.0f;
    coated.clearcoat = 1.0f;
    coated.emissive = {0.1f, 0.0f, 0.2f};
    builder.material(coated).box({0, 0.1f, -2}, {1, 2, -1});
    Material unlit;
    unlit.unlit = true;
    unlit.baseColorFactor = {0.2f, 0.7f, 0.1f, 1.0f};
    builder.material(unlit).box({1.5f, 0.3f, 0}, {2.5f, 0.8f, 1});
    Material cut;
    cut.alphaMode = AlphaMode::mask;
    cut.metallic = 0.0f;
    builder.material(cut).quad({-1, 0.5f, 1}, {0, 0.5f, 1}, {0, 1.5f, 1.3f}, {-1, 1.5f, 1.3f});
    Material glass;
    glass.alphaMode = AlphaMode::blend;
    glass.metallic = 0.0f;
    glass.baseColorFactor = {0.3f, 0.5f, 0.9f, 0.4f};
    builder.material(glass).box({-0.4f, 0.2f, 1.8f}, {0.6f, 0.9f, 2.4f});
    Scene scene = builder.scene();
    if (ground && !addGround(scene, {})) ADD_FAILURE() << "no ground";
    return scene;
}

std::vector<Light> lights() {
    Light ranged = pointLight({2, 4, 2});
    ranged.range = 6.0;
    return {sun({0.4, 1, 0.3}), sun({-0.9, 0.3, 0.4}), pointLight({1, 3, 2.5}), ranged};
}

std::vector<std::uint8_t> drawn(const Scene& scene, const Light& light, int slices,
                                const RenderSettings& settings) {
    test::TestView view{{{5, 4, 6}, {0, 0.4, 0}, 50.0}, {light}, width, height};
    view.depth.slices = slices;
    return test::drawScene(scene, view, settings);
}

/// Pixels that differ; where hardware draws, by more than roundings of two programs do.
std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    const int most = test::drawsOnProcessor() ? 0 : 2;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        bool differs = false;
        for (std::size_t c = i; c < i + 4; ++c)
            differs = differs || std::abs(int{a[c]} - int{b[c]}) > most;
        count += differs;
    }
    return count;
}

TEST(AmbientTarget, MakesTheSamePictures) {
    if (!isPossible()) GTEST_SKIP() << "one colour at a time";
    for (const bool ground : {false, true})
        for (const Light& light : lights())
            for (const int slices : {1, 3}) {
                SCOPED_TRACE(testing::Message() << "ground " << ground << ", light at "
                                                << light.position.x << ", slices " << slices);
                const Scene scene = display(ground);
                const auto off = drawn(scene, light, slices, full(AmbientTargetChoice::off));
                const auto on = drawn(scene, light, slices, full(AmbientTargetChoice::on));
                EXPECT_LE(differing(on, off), mostTies());
                RenderSettings unshadowed = full(AmbientTargetChoice::off);
                unshadowed.shadows = ShadowMethod::none;
                EXPECT_GT(differing(off, drawn(scene, light, slices, unshadowed)), 40u);
            }
}

/// That part of a picture of `width` x `height`: beside the viewport nobody asks.
std::vector<std::uint8_t> lowerLeft(const std::vector<std::uint8_t>& picture, int wide, int high) {
    std::vector<std::uint8_t> part;
    for (int y = height - high; y < height; ++y) {
        const auto row = picture.begin() + std::ptrdiff_t{4} * y * width;
        part.insert(part.end(), row, row + std::ptrdiff_t{4} * wide);
    }
    return part;
}

/// Draws frames of one scene, in a context that is current as long as no other is made.
class Frames {
  public:
    explicit Frames(const Scene& scene, AmbientTargetChoice choice)
        : context_(test::testPicture(width, height)),
          settings_(settingsFor(choice)), loaded_{{}, scene, {}, buildPlanePairs(scene, false),
                                                  {}, {}},
          gpu_(uploadScene(loaded_, settings_.records(), context_.capabilities())),
          renderer_(settings_, context_.capabilities()) {}

    std::vector<std::uint8_t> draw(int wide, int high) {
        const Frustum frustum =
            frustumOf({{5, 4, 6}, {0, 0.4, 0}, 50.0}, static_cast<double>(wide) / high);
        FrameView view =
            makeFrameView(loaded_.scene, false, {frustum, wide, high, {sun({0.4, 1, 0.3})}, {}});
        prepareScene(gpu_, loaded_, view, settings_, context_.capabilities());
        renderer_.draw(gpu_, view);
        gl::requireNoError("drawing");
        return lowerLeft(context_.readPixels(), wide, high);
    }
    std::size_t bytes() const { return renderer_.ambientBytes(); }

  private:
    RenderSettings settingsFor(AmbientTargetChoice choice) const {
        RenderSettings settings = full(choice);
        if (!context_.capabilities().instancing) settings.layout = SidesLayout::notInstanced;
        return settings;
    }

    gl::HeadlessContext context_;
    RenderSettings settings_;
    LoadedScene loaded_;
    GpuScene gpu_;
    Renderer renderer_;
};

TEST(AmbientTarget, FollowsThePicturesSize) {
    if (!isPossible()) GTEST_SKIP() << "one colour at a time";
    const auto drawn = [](AmbientTargetChoice choice) {
        Frames frames(display(false), choice);
        std::vector<std::vector<std::uint8_t>> pictures;
        for (const auto& [wide, high] :
             {std::pair(width, height), std::pair(40, 83), std::pair(121, 30)})
            pictures.push_back(frames.draw(wide, high));
        EXPECT_EQ(frames.bytes() > 0, choice == AmbientTargetChoice::on);
        return pictures;
    };
    const auto on = drawn(AmbientTargetChoice::on), off = drawn(AmbientTargetChoice::off);
    for (std::size_t i = 0; i < on.size(); ++i)
        EXPECT_LE(differing(on[i], off[i]), mostTies());
}

/// A metal relief of so many squares along a side.
Scene relief(int squares) {
    SceneBuilder builder;
    Material metal;
    metal.roughness = 0.4f;
    builder.material(metal);
    const float size = 6.0f / static_cast<float>(squares);
    const auto at = [&](int x, int z) {
        return glm::vec3(size * static_cast<float>(x) - 3.0f, (x + z) % 3 == 0 ? 0.3f : 0.0f,
                         size * static_cast<float>(z) - 3.0f);
    };
    for (int x = 0; x < squares; ++x)
        for (int z = 0; z < squares; ++z)
            builder.quad(at(x, z), at(x, z + 1), at(x + 1, z + 1), at(x + 1, z));
    return builder.scene();
}

TEST(AmbientTarget, IsThereWhereSurfacesTakeLongToDrawAgain) {
    if (!AmbientTarget::isWanted(full(AmbientTargetChoice::automatic), capabilities()))
        GTEST_SKIP() << "not the processor that draws, or one colour at a time";
    for (const int squares : {40, 4}) {
        Frames frames(relief(squares), AmbientTargetChoice::automatic);
        frames.draw(width, height);
        EXPECT_EQ(frames.bytes() > 0, squares == 40);
    }
}

TEST(AmbientTarget, IsRefusedWhereTheGLCannotDrawIntoIt) {
    gl::Capabilities one;
    EXPECT_FALSE(AmbientTarget::isWanted(full(AmbientTargetChoice::automatic), one));
    EXPECT_THROW(AmbientTarget::isWanted(full(AmbientTargetChoice::on), one), Error);
    one.drawBuffers.emplace();
    EXPECT_TRUE(AmbientTarget::isWanted(full(AmbientTargetChoice::on), one));
    one.samples = 4;
    EXPECT_THROW(AmbientTarget::isWanted(full(AmbientTargetChoice::on), one), Error);
    one.renderer = "llvmpipe";
    EXPECT_FALSE(AmbientTarget::isWanted(full(AmbientTargetChoice::automatic), one));
}

} // namespace
} // namespace edgeshade
