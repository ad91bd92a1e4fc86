// A host's tinted meshes multiply the light by what each of them lets through, where a light is
// looked up: a floor beneath them, judged by rays in double precision.
#include "src/engine/lookup_work.hpp"
#include "tests/engine/host_picture.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera above{{1, 5, 6}, {0, 0, 0}, 45.0};

/// A box, or a level sheet if it has no height.
struct Pane {
    glm::vec3 low, high;
    std::optional<std::array<float, 3>> tint; ///< none: solid

    Scene scene() const {
        if (low.y == high.y)
            return SceneBuilder()
                .quad(low, {low.x, low.y, high.z}, high, {high.x, low.y, low.z})
                .scene();
        return SceneBuilder().box(low, high).scene();
    }

    /// Whether the way from a point to the light leads through it.
    bool isMet(const glm::dvec3& from, const glm::dvec4& light) const {
        const glm::dvec3 towards = glm::dvec3(light) - light.w * from;
        double first = 1e-6, last = light.w > 0.0 ? 1.0 : 1e9;
        for (int i = 0; i < 3; ++i) {
            if (towards[i] == 0.0) {
                if (from[i] < low[i] || from[i] > high[i]) return false;
                continue;
            }
            const double a = (low[i] - from[i]) / towards[i], b = (high[i] - from[i]) / towards[i];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        return first <= last;
    }
};

/// Three panes above one another, one of them a solid, and a pillar.
std::vector<Pane> window() {
    return {{{-1.5f, 0.8f, -1.25f}, {0.75f, 0.8f, 1.0f}, {{0.9f, 0.25f, 0.5f}}},
            {{-0.5f, 1.2f, -0.5f}, {1.5f, 1.3f, 1.5f}, {{0.5f, 0.75f, 1.0f}}},
            {{-1.0f, 1.7f, -0.25f}, {1.0f, 1.7f, 1.25f}, {{1.0f, 0.6f, 0.0f}}},
            {{-1.9f, 0.1f, 0.4f}, {-1.6f, 1.1f, 0.7f}, {}}};
}

Scene floorScene() {
    return SceneBuilder().quad({-3, 0, -3}, {-3, 0, 3}, {3, 0, 3}, {3, 0, -3}).scene();
}

struct Judged {
    std::size_t tinted = 0, wrong = 0, beyond = 0;
};

class Host {
  public:
    explicit Host(std::vector<Pane> panes) : panes_(std::move(panes)) {
        masks.add(test::meshOf(geometryOf(floor_)));
        for (const Pane& pane : panes_) {
            const Scene scene = pane.scene();
            MaskMesh mesh = test::meshOf(geometryOf(scene));
            mesh.casts = mesh.visible = !pane.tint;
            ids.push_back(masks.add(mesh));
            masks.setTint(ids.back(), pane.tint);
        }
    }

    /// Draws the floor by lookup, and compares it with rays.
    Judged judge(const Light& light, HostPicture::Language language = {false, true, {true, true}}) {
        const MaskLight asked = hostLight(light);
        const auto id = lookedUp(masks, asked, {.restMs = 0.0, .casters = language.casters});
        HostPicture(masks, id, asked, viewOf(above), language)
            .draw(geometryOf(floor_), identity16, true);
        const std::vector<std::uint8_t> rgba = context.readPixels();
        const std::vector<unsigned> known = rays(light);
        Judged judged;
        for (int y = 0; y < hostHeight; ++y)
            for (int x = 0; x < hostWidth; ++x) {
                const auto at = static_cast<std::size_t>(y * hostWidth + x);
                const unsigned here = known[at];
                if (here == 0) continue;
                judged.tinted += here > 1;
                const glm::dvec3 drawn(rgba[4 * at], rgba[4 * at + 1], rgba[4 * at + 2]);
                const glm::dvec3 off = glm::abs(drawn - 255.0 * colourOf(here));
                if (std::max({off.x, off.y, off.z}) <= 1.0) continue;
                ++judged.wrong;
                judged.beyond += !isAtBorder(known, x, y);
            }
        return judged;
    }

    gl::HeadlessContext context{{hostWidth, hostHeight}};
    ShadowMasks masks{eglLookUp};
    std::vector<ShadowMasks::Id> ids;

  private:
    glm::dvec3 colourOf(unsigned met) const {
        glm::dvec3 colour(1.0);
        for (std::size_t i = 0; i < panes_.size(); ++i)
            if ((met >> (i + 1) & 1u) != 0)
                colour *= panes_[i].tint ? glm::dvec3(glm::make_vec3(panes_[i].tint->data()))
                                         : glm::dvec3(0.0);
        return colour;
    }

    /// By pixel: 0 no floor, else 1 and a bit for each pane on the way to the light.
    std::vector<unsigned> rays(const Light& light) const {
        std::vector<unsigned> known;
        for (const glm::dvec3& at : pointsOfGround(viewOf(above))) {
            known.push_back(0);
            if (std::max(std::abs(at.x), std::abs(at.z)) > 3.0) continue;
            known.back() = 1;
            for (std::size_t i = 0; i < panes_.size(); ++i)
                if (panes_[i].isMet(at, light.position)) known.back() |= 2u << i;
        }
        return known;
    }

    Scene floor_ = floorScene();
    std::vector<Pane> panes_;
};

void expectRight(const Judged& judged, std::size_t wrong = 30) {
    EXPECT_EQ(judged.beyond, 0u);
    EXPECT_LE(judged.wrong, wrong);
    EXPECT_GT(judged.tinted, 1000u);
}

} // namespace

TEST(TintLookup, IsTheProductOfAllPanesOnTheWay) {
    Host host(window());
    std::vector<HostPicture::Language> languages = {{false, true, {true, true}},
                                                    {false, false, {false, true}}};
    if (host.context.capabilities().version.starts_with("OpenGL ES 3"))
        languages.push_back({true, true, {false, true}});
    for (const Light& light : {sun({0.3, 1, 0.4}), sun({-0.2, 1, 0.9}), pointLight({0.4, 4, 0.7}),
                               pointLight({0.1, 1.5, 0.2})}) // among the panes: six tiles
        for (const HostPicture::Language language : languages) {
            SCOPED_TRACE(std::to_string(light.position.x) + " " +
                         std::to_string(language.version3 + 2 * language.derivatives));
            expectRight(host.judge(light, language));
        }
}

/// A tinted triangle's record in a host's table.
struct TintedRecord {
    std::array<glm::vec3, 3> edges;
    std::array<bool, 3> takes; ///< rays on an edge are its own
};

std::vector<TintedRecord> recordsOf(const PackedPrimitiveMap& map) {
    std::vector<TintedRecord> found;
    for (std::size_t at = map.begins[1]; at < map.count;) {
        const glm::vec4* texels = &map.texels[at];
        if (texels[0].w == -1.0f) { // a tint
            at += 3;
            continue;
        }
        found.push_back({{glm::vec3(texels[0]), glm::vec3(texels[1]), glm::vec3(texels[2])},
                         {texels[3].x > 0.5f, texels[3].y > 0.5f, texels[3].z > 0.5f}});
        at += 6;
    }
    return found;
}

TEST(TintLookup, GivesRaysOnAnEdgeToOneOfItsTriangles) {
    const Pane pane{{-1, 1, -1}, {1, 1, 1}, {{0.5f, 0.5f, 0.25f}}};
    const Scene scene = pane.scene();
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    MaskMesh mesh = test::meshOf(geometryOf(scene));
    mesh.casts = false;
    masks.setTint(masks.add(mesh), pane.tint);
    for (const Light& light :
         {sun({0.1, 1, 0.2}), sun({0.1, -1, 0.2}), pointLight({0.2, 1.6, 0.1})}) {
        LookupWork work = masks.lookupWork(hostLight(light), {.casters = {.tints = true}});
        work.finish();
        const std::vector<TintedRecord> records = recordsOf(work.data()->built.map);
        ASSERT_EQ(records.size(), 2u) << work.data()->built.why;
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                if (records[0].edges[i] == -records[1].edges[j]) {
                    ++shared;
                    EXPECT_NE(records[0].takes[i], records[1].takes[j]);
                }
        EXPECT_EQ(shared, 1u);
    }
}

TEST(TintLookup, OfASolidThatTheLightIsInIsThatOfLeaving) {
    const Pane globe{{-0.5f, 1, -0.5f}, {0.5f, 2, 0.5f}, {{1.0f, 0.5f, 0.25f}}};
    const Light lamp = pointLight({0.1, 1.6, 0.2});
    Host host({globe, window().front()});
    expectRight(host.judge(lamp), 60);
    Host mirrored({globe});
    mirrored.masks.move(mirrored.ids.front(),
                        numbersOf(glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0})));
    expectRight(mirrored.judge(lamp), 60);
    expectRight(mirrored.judge(pointLight({0.1, 4, 0.2})), 60);
}

TEST(TintLookup, IsAskedForAndFollowsChanges) {
    Host host(window());
    const Light light = sun({0.3, 1, 0.4});
    EXPECT_GT(host.judge(light, {}).beyond, 500u) << "no tint without asking";
    const auto before = host.masks.casterState();
    host.masks.setTint(host.ids[0], window()[0].tint);
    EXPECT_EQ(host.masks.casterState(), before);
    host.masks.setTint(host.ids[0], {{0.5f, 0.5f, 0.5f}});
    EXPECT_NE(host.masks.casterState(), before);
    EXPECT_GT(host.judge(light).beyond, 100u);
    const auto changed = host.masks.casterState();
    host.masks.setTint(host.ids[0], {});
    EXPECT_NE(host.masks.casterState(), changed);
    for (const float wrong : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_THROW(host.masks.setTint(host.ids[0], {{0.5f, wrong, 0.5f}}), std::runtime_error);
    EXPECT_THROW(host.masks.setTint(99, {}), std::runtime_error);
}

/// A sheet of 2 x 2 above the floor's middle, whose texture coordinates are 0..1, and its texture.
struct TexturedPane {
    const Scene scene = SceneBuilder().quad({-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}).scene();
    std::vector<float> texcoords;
    std::shared_ptr<MaskTexels> texels = std::make_shared<MaskTexels>();

    TexturedPane() {
        for (const glm::vec3& at : geometryOf(scene).positions)
            texcoords.insert(texcoords.end(), {0.5f + 0.5f * at.x, 0.5f + 0.5f * at.z});
        *texels = {.width = 3,
                   .height = 2,
                   .alpha = {4080, 0, 2040, 1020, 4080, 510, 4080, 4080, 1020, 2040, 3060, 0, 0,
                             2040, 4080, 510, 1020, 3060},
                   .wrapS = MaskTexels::Wrap::mirror,
                   .wrapT = MaskTexels::Wrap::clamp};
    }

    /// Share of red, green and blue that its texture lets through at texture coordinates.
    glm::dvec3 at(const glm::dvec2& uv) const {
        const auto texel = [&](double x, double y) {
            const double rest = x - 6.0 * std::floor(x / 6.0);
            const auto column = static_cast<std::size_t>(rest < 3.0 ? rest : 5.0 - rest);
            const auto row = static_cast<std::size_t>(std::clamp(y, 0.0, 1.0));
            glm::dvec3 of(0.0);
            for (std::size_t i = 0; i < 3; ++i)
                of[static_cast<glm::length_t>(i)] =
                    texels->alpha[6 * i + 3 * row + column] / 4080.0;
            return of;
        };
        const glm::dvec2 place = uv * glm::dvec2(3, 2);
        if (!texels->linear) return texel(std::floor(place.x), std::floor(place.y));
        const glm::dvec2 first = glm::floor(place - 0.5), share = place - 0.5 - first;
        return glm::mix(
            glm::mix(texel(first.x, first.y), texel(first.x + 1, first.y), share.x),
            glm::mix(texel(first.x, first.y + 1), texel(first.x + 1, first.y + 1), share.x),
            share.y);
    }
};

TEST(TintLookup, IsMultipliedByATextureOfThePane) {
    TexturedPane pane;
    const Scene floor = floorScene();
    for (const bool linear : {true, false})
        for (const Light& light : {sun({0.3, 1, 0.4}), pointLight({0.4, 4, 0.7})}) {
            const gl::HeadlessContext context({hostWidth, hostHeight});
            ShadowMasks masks(eglLookUp);
            masks.add(test::meshOf(geometryOf(floor)));
            MaskMesh mesh = test::meshOf(geometryOf(pane.scene));
            mesh.casts = mesh.visible = false;
            mesh.texcoords = pane.texcoords;
            const auto id = masks.add(mesh);
            pane.texels->linear = linear;
            const MaskTintTexture texture{pane.texels, {0, 1.3f, 0, 0.8f, 0, 0, -0.4f, 0.2f, 1}};
            masks.setTint(id, {{1.0f, 0.5f, 0.75f}}, texture);
            const LookupCasters casters{false, true};
            const MaskLight asked = hostLight(light);
            const auto lookup = lookedUp(masks, asked, {.restMs = 0.0, .casters = casters});
            HostPicture(masks, lookup, asked, viewOf(above), {false, true, casters})
                .draw(geometryOf(floor), identity16, true);
            const std::vector<std::uint8_t> rgba = context.readPixels();
            std::size_t tinted = 0, wrong = 0;
            const std::vector<glm::dvec3> points = pointsOfGround(viewOf(above));
            for (std::size_t i = 0; i < points.size(); ++i) {
                const glm::dvec3& from = points[i];
                if (std::max(std::abs(from.x), std::abs(from.z)) > 3.0) continue;
                const glm::dvec3 towards = glm::dvec3(light.position) - light.position.w * from;
                const glm::dvec3 met = from + towards * ((1.0 - from.y) / towards.y);
                if (std::max(std::abs(met.x), std::abs(met.z)) > 0.97) continue; // or its outline
                const glm::dvec2 own(0.5 + 0.5 * met.x, 0.5 + 0.5 * met.z);
                const glm::dvec3 colour =
                    pane.at({0.8 * own.y - 0.4, 1.3 * own.x + 0.2}) * glm::dvec3(1.0, 0.5, 0.75);
                const glm::dvec3 off = glm::abs(
                    glm::dvec3(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]) - 255.0 * colour);
                ++tinted;
                wrong += std::max({off.x, off.y, off.z}) > 1.5;
            }
            EXPECT_GT(tinted, 1000u);
            // Rays at the border of two texels may be on either side.
            EXPECT_LE(wrong, linear ? 0u : tinted / 500);
            const auto before = masks.casterState();
            masks.setTint(id, {{1.0f, 0.5f, 0.75f}}, texture);
            EXPECT_EQ(masks.casterState(), before);
            masks.setTint(id, {{1.0f, 0.5f, 0.75f}});
            EXPECT_NE(masks.casterState(), before);
            MaskTexels single = *pane.texels;
            single.alpha.resize(6);
            EXPECT_THROW(
                masks.setTint(id, {{1, 1, 1}}, {std::make_shared<const MaskTexels>(single)}),
                std::runtime_error);
        }
}

TEST(InvisibleMeshes, AreNotInMasksAndMayCast) {
    const Scene scene = yard().scene(), pane = window()[1].scene();
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const MaskLight light = hostLight(sun({0.3, 1, 0.4}));
    ShadowMasks masks(eglLookUp), without(eglLookUp);
    for (ShadowMasks* of : {&masks, &without})
        of->add(test::meshOf(geometryOf(scene)));
    const auto drawn = [&](ShadowMasks& of) {
        of.draw(viewOf(above), {&light, 1});
        return readMask(of, 0);
    };
    MaskMesh mesh = test::meshOf(geometryOf(pane));
    mesh.casts = mesh.visible = false;
    // As many as would be merged, for longer than that takes.
    std::vector<ShadowMasks::Id> ids;
    for (int i = 0; i < 5; ++i)
        ids.push_back(masks.add(mesh));
    const auto expected = drawn(without);
    for (int i = 0; i < 40; ++i)
        ASSERT_EQ(drawn(masks), expected) << i;
    mesh.casts = true;
    for (const auto id : ids)
        masks.change(id, PreparedMesh(mesh));
    const auto cast = drawn(masks);
    for (int i = 0; i < 40; ++i)
        ASSERT_EQ(drawn(masks), cast) << i;
    std::size_t darker = 0, lighter = 0;
    for (std::size_t i = 0; i < cast.size(); ++i) {
        darker += cast[i] < expected[i];
        lighter += cast[i] > expected[i];
    }
    EXPECT_GT(darker, 300u);
    EXPECT_EQ(lighter, 0u) << "what is behind it is seen";
}

TEST(TintLookup, AloneMapsHoldWhatMasksLackAndSayWhyThereIsNone) {
    // The pillar, a solid, is the masks'.
    std::vector<Pane> panes = window();
    Host host(panes);
    const MaskLight light = hostLight(sun({0.3, 1, 0.25}));
    LookupSettings alone{.casters = {true, true}};
    alone.cutoutsAlone = true;
    host.masks.move(host.ids[1], numbersOf(glm::translate(glm::dmat4(1.0), {0.25, 0, 0})));
    const LookupWork work = host.masks.lookupWork(light, alone);
    EXPECT_EQ(work.data()->task.casters.size(), 3u) << "panes, one of which has just moved";
    for (const LookupTask::Caster& caster : work.data()->task.casters)
        EXPECT_TRUE(caster.cutout.tint);
    alone.mostTriangles = 15;
    EXPECT_EQ(host.masks.lookup(lookedUp(host.masks, light, alone)).why,
              "its casters have 16 triangles, more than 15");
    alone.mostTriangles = 16;
    EXPECT_EQ(host.masks.lookup(lookedUp(host.masks, light, alone)).why, "");
    for (const ShadowMasks::Id id : host.ids)
        host.masks.setTint(id, {});
    EXPECT_EQ(host.masks.lookup(lookedUp(host.masks, light, alone)).why,
              "no cutouts or tints cast");
}

} // namespace edgeshade
