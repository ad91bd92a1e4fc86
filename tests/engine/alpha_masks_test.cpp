// A host's alpha-tested meshes have the same masks as a MASK material in `render --mask`; they cast
// as whole triangles, as with `--cast-masked`.
#include "tests/engine/masks_in_a_host.hpp"

#include <GLES2/gl2.h>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const Light noon = sun({0.5, 1, -0.3}), lamp = pointLight({0.3, 4, 0.7});
constexpr float cutoff = 0.4f, opacity = 0.9f;

/// Squares with different alphas, and with different greens.
Image pattern() {
    constexpr int size = 8;
    Image image{size, size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto alpha =
                static_cast<std::uint8_t>((x / 2 + y / 2) % 2 ? 250 - 10 * x : 9 * y);
            image.rgba.insert(image.rgba.end(),
                              {0, static_cast<std::uint8_t>(x % 2 ? 255 : 3), 128, alpha});
        }
    return image;
}

/// The same with alpha in the green channel, and none of it in alpha.
Image inGreen(Image image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        image.rgba[i + 1] = image.rgba[i + 3];
        image.rgba[i + 3] = 255;
    }
    return image;
}

/// Two sheets with holes, one of them in front of much of the scene.
Scene sheets(bool doubleSided) {
    Material material;
    material.alphaMode = AlphaMode::mask;
    material.doubleSided = doubleSided;
    material.alphaCutoff = cutoff;
    material.baseColorFactor.a = opacity;
    material.of(TextureSlot::baseColor).texture = material.of(TextureSlot::baseColor).image = 0;
    Scene scene = SceneBuilder()
                      .material(material)
                      .quad({-1, 0.4f, 4.5f}, {4, 0.3f, 3}, {4, 3, 3}, {-1, 3.5f, 4.5f})
                      .quad({-3, 3, -2}, {-3, 2.5f, 1}, {0, 2.6f, 1}, {0, 3, -2})
                      .scene();
    Geometry& geometry = scene.batches.front().geometry.edit();
    for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
        const glm::vec3& at = geometry.positions[i];
        geometry.texcoords[i] = {0.3f * at.x + 0.2f * at.z, 0.4f * at.y + 0.1f * at.z};
    }
    return scene;
}

/// A yard and the sheets; all other surfaces are seen from both sides.
Scene yardWith(const Scene& sheets) {
    Scene scene = yard().scene();
    scene.materials = sheets.materials;
    scene.materials.front().doubleSided = true;
    scene.batches.push_back(sheets.batches.front());
    scene.culls = true;
    return scene;
}

/// Texture coordinates in the engine's form, multiplied by a number.
std::vector<float> texcoordsOf(const Geometry& geometry, float times) {
    std::vector<float> texcoords;
    for (const glm::vec2& uv : geometry.texcoords)
        texcoords.insert(texcoords.end(), {times * uv.x, times * uv.y});
    return texcoords;
}

/// A host that draws with its own texture.
struct Host {
    explicit Host(const Image& image = pattern())
        : context({hostWidth, hostHeight}),
          texture(gl::makeTexture(image.rgba, image.width, image.height, {})), masks(eglLookUp) {
        masks.add(meshOf(*yard().scene().batches.front().geometry));
    }

    ShadowMasks::Id add(const Scene& sheets, bool casts, float texcoordScale = 1.0f) {
        const Geometry& geometry = *sheets.batches.front().geometry;
        const std::vector<float> texcoords = texcoordsOf(geometry, texcoordScale);
        MaskMesh mesh = meshOf(geometry);
        mesh.casts = casts;
        mesh.doubleSided = sheets.materials.back().doubleSided;
        mesh.alphaTested = true;
        mesh.texcoords = texcoords;
        const ShadowMasks::Id id = masks.add(mesh);
        masks.setAlpha(id, alpha());
        return id;
    }

    MaskAlpha alpha() const {
        return {.texture = texture.name(), .opacity = opacity, .cutoff = cutoff};
    }

    std::vector<std::uint8_t> drawn(const Light& light) {
        const MaskLight asked = hostLight(light);
        masks.draw(viewOf(corner), {&asked, 1});
        return readMask(masks, 0);
    }

    gl::HeadlessContext context;
    gl::Texture texture;
    ShadowMasks masks;
};

std::vector<std::uint8_t> rendered(const Scene& scene, const Light& light, bool castMasked) {
    return renderedMask(scene, corner, light, {{0, std::make_shared<const Image>(pattern())}},
                        castMasked);
}

std::size_t different(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

} // namespace

TEST(AlphaMasks, ShowThroughHolesTheShadowOfWhatIsSeen) {
    const Scene both = sheets(true);
    for (const Light& light : {noon, lamp}) {
        const auto expected = rendered(yardWith(both), light, false);
        Host host;
        const auto without = host.drawn(light);
        const auto id = host.add(both, false);
        EXPECT_EQ(host.drawn(light), expected);
        MaskAlpha solid = host.alpha();
        solid.cutoff = 0.0f;
        host.masks.setAlpha(id, solid);
        EXPECT_GT(different(host.drawn(light), expected), 500u) << "holes should be seen";
        EXPECT_GT(different(without, expected), 500u) << "what is no hole should be seen";
    }
}

TEST(AlphaMasks, OfWhatCastsAreThoseOfWholeTriangles) {
    for (const bool doubleSided : {true, false})
        for (const Light& light : {noon, lamp}) {
            const Scene both = sheets(doubleSided);
            const auto expected = rendered(yardWith(both), light, true);
            Host host;
            const auto id = host.add(both, true);
            EXPECT_EQ(host.drawn(light), expected) << doubleSided;
            host.masks.remove(id);
            host.add(both, false);
            EXPECT_GT(different(host.drawn(light), expected), 500u) << "they should cast";
        }
}

TEST(AlphaMasks, OfMoreLayersThanTheStencilCountsAreExact) {
    SceneBuilder builder;
    builder.material(sheets(true).materials.back());
    for (int i = 0; i < 270; ++i) {
        const float y = 2.0f + 0.004f * static_cast<float>(i);
        builder.quad({-2, y, -2}, {-2, y, 1}, {1, y, 1}, {1, y, -2});
    }
    Scene many = builder.scene();
    for (std::size_t i = 0; i < many.batches.front().geometry->positions.size(); ++i)
        many.batches.front().geometry.edit().texcoords[i] = {
            0.4f * many.batches.front().geometry->positions[i].x,
            0.4f * many.batches.front().geometry->positions[i].z};
    const auto expected = rendered(yardWith(many), noon, true);
    Host host;
    const auto without = host.drawn(noon);
    host.add(many, true);
    EXPECT_EQ(different(host.drawn(noon), expected), 0u);
    EXPECT_GT(different(without, expected), 500u);
}

TEST(AlphaMasks, FindAlphaInGreenAndByATransform) {
    const Scene both = sheets(true);
    const auto expected = rendered(yardWith(both), noon, true);
    Host host(inGreen(pattern()));
    const auto id = host.add(both, true, 0.25f);
    MaskAlpha alpha = host.alpha();
    alpha.channel = MaskAlpha::Channel::green;
    alpha.texcoordTransform = {4, 0, 0, 0, 4, 0, 0, 0, 1};
    host.masks.setAlpha(id, alpha);
    EXPECT_EQ(host.drawn(noon), expected);
    // Undoes the rotation and offset of the vertices' coordinates.
    alpha.texcoordTransform = {0, 4, 0, 4, 0, 0, 0, 0, 1};
    host.masks.setAlpha(id, alpha);
    EXPECT_GT(different(host.drawn(noon), expected), 500u);
    alpha.channel = MaskAlpha::Channel::alpha;
    alpha.cutoff = 0.95f;
    host.masks.setAlpha(id, alpha); // all hole: only its shadow is left
    Host alone;
    const auto none = alone.add(both, true);
    alone.masks.setAlpha(none, {.opacity = 0.1f});
    EXPECT_EQ(host.drawn(noon), alone.drawn(noon));
}

TEST(AlphaMasks, TellHowFarAwayIsWhatIsSeenThroughHoles) {
    const Scene both = sheets(true);
    Host host;
    const MaskLight asked = hostLight(noon);
    const auto nearness = [&] {
        MaskView view = viewOf(corner);
        view.nearness = true;
        host.masks.draw(view, {&asked, 1});
        return readTexture(host.masks.nearness().texture);
    };
    const auto id = host.add(both, false);
    const auto holes = nearness();
    MaskAlpha alpha = host.alpha();
    alpha.cutoff = 0.0f;
    host.masks.setAlpha(id, alpha);
    const auto solid = nearness();
    alpha.cutoff = 2.0f;
    host.masks.setAlpha(id, alpha);
    const auto nothing = nearness();
    std::size_t ofSheets = 0, ofHoles = 0;
    for (std::size_t i = 0; i < holes.size(); i += 4) {
        const auto same = [&](const std::vector<std::uint8_t>& other) {
            return std::equal(&holes[i], &holes[i] + 4, &other[i]);
        };
        ASSERT_TRUE(same(solid) || same(nothing)) << i;
        ofSheets += same(solid) && !same(nothing);
        ofHoles += same(nothing) && !same(solid);
    }
    EXPECT_GT(ofSheets, 500u);
    EXPECT_GT(ofHoles, 500u);
}

TEST(AlphaMasks, OfOneMeshMayDifferByPlace) {
    Host host;
    const Scene both = sheets(true);
    const auto whole = host.add(both, false);
    const auto expected = host.drawn(noon);
    // The same mesh in another place, out of sight, has no effect.
    const Geometry& geometry = *both.batches.front().geometry;
    const std::vector<float> texcoords = texcoordsOf(geometry, 1.0f);
    MaskMesh mesh = meshOf(geometry);
    mesh.casts = false;
    mesh.alphaTested = true;
    mesh.texcoords = texcoords;
    const PreparedMesh prepared(mesh);
    Matrix16 away = identity16;
    away[13] = 1000.0;
    const auto first = host.masks.add(prepared), second = host.masks.add(prepared, away);
    host.masks.remove(whole);
    host.masks.setAlpha(second, {.cutoff = 0.0f});
    host.masks.setAlpha(first, host.alpha());
    EXPECT_EQ(host.drawn(noon), expected);
    // A replaced mesh has no holes until they are set.
    host.masks.change(first, prepared);
    EXPECT_NE(host.drawn(noon), expected);
    host.masks.setAlpha(first, host.alpha());
    EXPECT_EQ(host.drawn(noon), expected);
}

TEST(AlphaMasks, RefuseWhatIsWrongInASentence) {
    Host host;
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0}, few = {0, 0, 1, 0};
    const std::vector<std::uint32_t> indices = {0, 1, 2};
    MaskMesh mesh{.positions = positions, .indices = indices};
    const auto opaque = host.masks.add(mesh);
    EXPECT_THROW(host.masks.setAlpha(opaque, {}), std::runtime_error);
    mesh.alphaTested = true;
    mesh.texcoords = few;
    EXPECT_THROW(host.masks.add(mesh), std::runtime_error);
    const std::vector<float> infinite = {0, 0, 1, 0, INFINITY, 0};
    mesh.texcoords = infinite;
    EXPECT_THROW(host.masks.add(mesh), std::runtime_error);
    mesh.texcoords = {};
    const auto tested = host.masks.add(mesh);
    EXPECT_THROW(host.masks.setAlpha(tested, {.cutoff = NAN}), std::runtime_error);
    EXPECT_THROW(host.masks.setAlpha(tested + 1, {}), std::runtime_error);
}

} // namespace edgeshade
