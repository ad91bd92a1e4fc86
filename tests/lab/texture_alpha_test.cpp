// Alpha of a texture between and beyond its texels, by the rules of GLES 2 samplers.

#include "src/lab/texture_alpha.hpp"

#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int repeat = 10497, mirroredRepeat = 33648, clampToEdge = 33071;
constexpr int nearest = 9728, linear = 9729, mipmapped = 9987;

/// A triangle with texture coordinates (0, 0), (4, 0), (0, 4) and a row of texels whose alphas go
/// from 0 to 1.
struct Fixture {
    LoadedScene loaded;
    rays::SurfaceTriangle triangle{};

    explicit Fixture(const Sampler& sampler, int texels = 4) : texels_(texels) {
        Material material;
        material.alphaMode = AlphaMode::mask;
        material.of(TextureSlot::baseColor).image = 0;
        material.of(TextureSlot::baseColor).sampler = sampler;
        loaded.scene = test::SceneBuilder()
                           .material(material)
                           .triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0})
                           .scene();
        Batch& batch = loaded.scene.batches.front();
        for (std::size_t i = 0; i < 3; ++i)
            batch.geometry.edit().texcoords[batch.geometry->indices[i]] =
                glm::vec2(batch.geometry->positions[batch.geometry->indices[i]]);
        Image image{texels, 1, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(texels))};
        for (int i = 0; i < texels; ++i)
            image.rgba[4 * static_cast<std::size_t>(i) + 3] =
                static_cast<std::uint8_t>(255 * i / (texels - 1));
        loaded.images.emplace(0, std::make_shared<const Image>(std::move(image)));
        triangle.material = static_cast<std::uint32_t>(batch.geometry->groups.back().material);
        triangle.geometry = &*batch.geometry;
    }

    /// Alpha at a texture coordinate along the row, 0 to 4.
    float at(double s) const { return lab::textureAlpha(loaded).at(triangle, s / 4.0, 0.0); }

    /// Range of alpha around a place in texels, for pixels of this width and height in texels.
    glm::vec2 range(double place, double width) const {
        const double across = 4.0 * texels_; // texels, for a barycentric coordinate of 1
        return lab::textureAlpha(loaded).range(triangle, {glm::dvec2(place, 0.0) / across,
                                                          glm::dvec2(place + width, 0.0) / across,
                                                          glm::dvec2(place / across, 0.0)});
    }

  private:
    int texels_;
};

Sampler samplerOf(int wrap, int mag, int min = linear) {
    return {wrap, wrap, min, mag};
}

TEST(TextureAlpha, WrapsAsTheSamplerSays) {
    // 1.125: the middle of the first texel of the second copy.
    EXPECT_NEAR(Fixture(samplerOf(repeat, nearest)).at(1.125), 0.0, 1e-6);
    EXPECT_NEAR(Fixture(samplerOf(mirroredRepeat, nearest)).at(1.125), 1.0, 1e-6);
    EXPECT_NEAR(Fixture(samplerOf(mirroredRepeat, nearest)).at(2.125), 0.0, 1e-6);
    EXPECT_NEAR(Fixture(samplerOf(clampToEdge, nearest)).at(1.125), 1.0, 1e-6);
    EXPECT_NEAR(Fixture(samplerOf(clampToEdge, nearest)).at(3.6), 1.0, 1e-6);
}

TEST(TextureAlpha, MagnifiesAsTheSamplerSays) {
    const Fixture hard(samplerOf(repeat, nearest)), soft(samplerOf(repeat, linear));
    EXPECT_NEAR(hard.at(0.26), 1.0 / 3.0, 1e-6);
    EXPECT_NEAR(hard.at(0.49), 1.0 / 3.0, 1e-6);
    EXPECT_NEAR(soft.at(0.375), 1.0 / 3.0, 1e-6); // a texel's centre
    EXPECT_NEAR(soft.at(0.5), 0.5, 1e-6);         // between two
    EXPECT_NEAR(soft.at(1.0), 0.5, 1e-6);         // the last and the first of the next copy
    EXPECT_NEAR(Fixture(samplerOf(clampToEdge, linear)).at(1.0), 1.0, 1e-6);
}

TEST(TextureAlpha, RangesHoldWhatDevicesMayLookUp) {
    // A small pixel samples a texel and a half to either side.
    const glm::vec2 small = Fixture(samplerOf(clampToEdge, linear), 16).range(6.5, 0.25);
    EXPECT_NEAR(small.x, 5.0 / 15.0, 1e-6);
    EXPECT_NEAR(small.y, 8.0 / 15.0, 1e-6);
    // A large one samples mipmaps, here with texels of four.
    const glm::vec2 large = Fixture(samplerOf(clampToEdge, linear, mipmapped), 16).range(6.5, 3.0);
    EXPECT_NEAR(large.x, 0.0, 1e-6);
    EXPECT_NEAR(large.y, 12.0 / 15.0, 1e-6);
    // Without mipmaps it samples no more than a small one.
    EXPECT_EQ(Fixture(samplerOf(clampToEdge, linear), 16).range(6.5, 3.0), small);
}

} // namespace
} // namespace edgeshade
