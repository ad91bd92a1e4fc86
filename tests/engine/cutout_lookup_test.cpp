// A host's alpha-tested meshes cast what their alpha leaves where a light is looked up: a floor
// beneath them, judged by rays in double precision.
#include "tests/engine/host_picture.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>
#include <random>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera above{{1, 5, 6}, {0, 0, 0}, 45.0};

/// A cutout, and what decides which of its rays are blocked.
struct Sheet {
    std::array<glm::dvec3, 4> corners; ///< of a parallelogram, in order
    MaskAlpha alpha;
    float low = -0.7f, high = 2.3f; ///< texture coordinates along either edge

    glm::dvec3 u() const { return corners[1] - corners[0]; }
    glm::dvec3 v() const { return corners[3] - corners[0]; }
};

double wrapped(double place, int size, MaskTexels::Wrap wrap) {
    if (wrap == MaskTexels::Wrap::clamp) return std::clamp(place, 0.0, size - 1.0);
    const double period = wrap == MaskTexels::Wrap::mirror ? 2.0 * size : size;
    const double rest = place - period * std::floor(place / period);
    return rest < size ? rest : period - 1.0 - rest;
}

double alphaOf(const MaskTexels& texels, const glm::dvec2& uv) {
    const glm::dvec2 place = uv * glm::dvec2(texels.width, texels.height);
    const auto at = [&](double x, double y) {
        const double column = wrapped(x, texels.width, texels.wrapS);
        const double row = wrapped(y, texels.height, texels.wrapT);
        return texels.alpha[static_cast<std::size_t>(row * texels.width + column)] / 4080.0;
    };
    if (!texels.linear) return at(std::floor(place.x), std::floor(place.y));
    const glm::dvec2 first = glm::floor(place - 0.5), share = place - 0.5 - first;
    return glm::mix(glm::mix(at(first.x, first.y), at(first.x + 1, first.y), share.x),
                    glm::mix(at(first.x, first.y + 1), at(first.x + 1, first.y + 1), share.x),
                    share.y);
}

bool blocks(const Sheet& sheet, const glm::dvec3& from, const glm::dvec4& light) {
    const glm::dvec3 towards = glm::dvec3(light) - light.w * from;
    const glm::dvec3 normal = glm::cross(sheet.u(), sheet.v());
    const double way = glm::dot(normal, sheet.corners[0] - from) / glm::dot(normal, towards);
    if (!(way > 0.0) || (light.w > 0.0 && way >= 1.0)) return false;
    const glm::dvec3 at = from + way * towards - sheet.corners[0];
    const double square = glm::dot(normal, normal);
    const glm::dvec2 part{glm::dot(glm::cross(at, sheet.v()), normal) / square,
                          glm::dot(glm::cross(sheet.u(), at), normal) / square};
    if (part.x < 0.0 || part.x > 1.0 || part.y < 0.0 || part.y > 1.0) return false;
    if (!sheet.alpha.texels) return sheet.alpha.opacity >= sheet.alpha.cutoff;
    const glm::dvec2 uv = glm::dvec2(sheet.low) + part * double{sheet.high - sheet.low};
    const glm::dmat3 transform(glm::make_mat3(sheet.alpha.texcoordTransform.data()));
    return sheet.alpha.opacity *
               alphaOf(*sheet.alpha.texels, glm::dvec2(transform * glm::dvec3(uv, 1.0))) >=
           sheet.alpha.cutoff;
}

MaskMesh meshOf(const Sheet& sheet, bool casts) {
    static std::vector<float> positions, texcoords;
    static const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3};
    positions.clear();
    for (const glm::dvec3& corner : sheet.corners)
        for (int i = 0; i < 3; ++i)
            positions.push_back(static_cast<float>(corner[i]));
    texcoords = {sheet.low,  sheet.low,  sheet.high, sheet.low,
                 sheet.high, sheet.high, sheet.low,  sheet.high};
    MaskMesh mesh{.positions = positions, .indices = indices};
    mesh.casts = casts;
    mesh.alphaTested = true;
    mesh.texcoords = texcoords;
    return mesh;
}

std::shared_ptr<MaskTexels> blobs(int width, int height, unsigned seed) {
    std::mt19937 draw(seed);
    auto texels = std::make_shared<MaskTexels>();
    texels->width = width;
    texels->height = height;
    for (int i = 0; i < width * height; ++i)
        texels->alpha.push_back(static_cast<std::uint16_t>(draw() % 256 * 16));
    return texels;
}

Sheet slanted(MaskAlpha alpha) {
    alpha.cutsOut = true;
    return {{glm::dvec3{-1.5, 0.6, -1.25}, {1.0, 1.0, -1.5}, {1.5, 1.5, 1.0}, {-1.0, 1.1, 1.25}},
            std::move(alpha)};
}

Sheet small(MaskAlpha alpha) {
    alpha.cutsOut = true;
    return {{glm::dvec3{0.25, 1.75, 0.5}, {1.25, 1.75, 0.5}, {1.25, 2.0, 1.5}, {0.25, 2.0, 1.5}},
            std::move(alpha)};
}

Scene floorScene() {
    return SceneBuilder().quad({-3, 0, -3}, {-3, 0, 3}, {3, 0, 3}, {3, 0, -3}).scene();
}

/// Draws the floor by lookup, and compares it with rays.
struct Judged {
    std::size_t dark = 0, wrong = 0, beyond = 0;
};

class Host {
  public:
    explicit Host(std::vector<Sheet> sheets, bool casts = false) : sheets_(std::move(sheets)) {
        masks.add(test::meshOf(geometryOf(floor_)));
        for (const Sheet& sheet : sheets_) {
            ids.push_back(masks.add(meshOf(sheet, casts)));
            masks.setAlpha(ids.back(), sheet.alpha);
        }
    }

    Judged judge(const Light& light, HostPicture::Language language = {false, true, {true}},
                 const LookupSettings& settings = {.restMs = 0.0, .casters = {true}}) {
        const MaskLight asked = hostLight(light);
        const auto id = lookedUp(masks, asked, settings);
        HostPicture(masks, id, asked, viewOf(above), language)
            .draw(geometryOf(floor_), identity16, true);
        const std::vector<std::uint8_t> rgba = context.readPixels();
        const std::vector<int> known = rays(light);
        Judged judged;
        for (int y = 0; y < hostHeight; ++y)
            for (int x = 0; x < hostWidth; ++x) {
                const auto at = static_cast<std::size_t>(y * hostWidth + x);
                const int here = known[at];
                if (here == 0) continue;
                judged.dark += here == 1;
                if ((rgba[4 * at] > 127) == (here == 2)) continue;
                ++judged.wrong;
                judged.beyond += !isAtBorder(known, x, y);
            }
        return judged;
    }

    gl::HeadlessContext context{{hostWidth, hostHeight}};
    ShadowMasks masks{eglLookUp};
    std::vector<ShadowMasks::Id> ids;

  private:
    /// By pixel: 0 no floor, 1 in shadow, 2 lit.
    std::vector<int> rays(const Light& light) const {
        std::vector<int> known;
        for (const glm::dvec3& at : pointsOfGround(viewOf(above))) {
            if (std::max(std::abs(at.x), std::abs(at.z)) > 3.0) {
                known.push_back(0);
                continue;
            }
            known.push_back(2);
            for (const Sheet& sheet : sheets_)
                if (blocks(sheet, at, light.position)) known.back() = 1;
        }
        return known;
    }

    Scene floor_ = floorScene();
    std::vector<Sheet> sheets_;
};

const std::vector<Light>& someLights() {
    static const std::vector<Light> lights = {sun({0.3, 1, 0.4}), pointLight({1, 5, 2}),
                                              pointLight({0.1, 1.6, 0.2})}; // six tiles
    return lights;
}

} // namespace

TEST(CutoutLookup, IsExactForEveryWrapAndFilter) {
    using Wrap = MaskTexels::Wrap;
    for (const auto& [s, t, linear] : {std::tuple{Wrap::repeat, Wrap::mirror, true},
                                       {Wrap::mirror, Wrap::clamp, false},
                                       {Wrap::clamp, Wrap::repeat, true},
                                       {Wrap::repeat, Wrap::repeat, false}}) {
        const auto oak = blobs(8, 16, 7), fern = blobs(5, 3, 3);
        for (const auto& texels : {oak, fern}) {
            texels->wrapS = s;
            texels->wrapT = t;
            texels->linear = linear;
        }
        Host host(
            {slanted({.texels = oak}), small({.opacity = 0.8f, .cutoff = 0.3f, .texels = fern})});
        for (const Light& light : someLights())
            for (const HostPicture::Language language :
                 languages(host.context.capabilities(), {true})) {
                const Judged judged = host.judge(light, language);
                SCOPED_TRACE(std::to_string(static_cast<int>(s)) + std::to_string(linear));
                EXPECT_EQ(judged.beyond, 0u) << light.position.x << language.version3;
                EXPECT_LE(judged.wrong, 30u);
                EXPECT_GT(judged.dark, 1000u);
            }
    }
}

TEST(CutoutLookup, FollowsTransformsAndAlphasWithoutATexture) {
    const auto texels = blobs(16, 16, 5);
    const MaskAlpha turned{.texcoordTransform = {0.9f, 0.6f, 0, -0.5f, 1.1f, 0, 0.3f, -0.2f, 1},
                           .texels = texels};
    Host host({slanted(turned), small({.opacity = 0.7f, .cutoff = 0.6f})});
    EXPECT_EQ(host.judge(someLights()[0]).beyond, 0u);
    Host faded({slanted(turned), small({.opacity = 0.5f, .cutoff = 0.6f})});
    EXPECT_EQ(faded.judge(someLights()[1]).beyond, 0u);
}

TEST(CutoutLookup, OfManyMeshesOfOneTextureKeepsItOnce) {
    const auto texels = blobs(256, 256, 5);
    std::vector<Sheet> sheets(9, slanted({.texels = texels}));
    Host host(sheets);
    const MaskLight light = hostLight(someLights()[0]);
    const LookupSettings settings{.mostBytes = 2 * 256 * 256 * 2, .casters = {true}};
    LookupWork work = host.masks.lookupWork(light, settings);
    work.finish();
    EXPECT_EQ(host.masks.lookup(host.masks.addLookup(work)).why, "");
}

TEST(CutoutLookup, IsAskedFor) {
    const auto texels = blobs(8, 8, 5);
    const Light light = someLights()[0];
    for (const bool casts : {false, true}) {
        Host host({slanted({.texels = texels})}, casts);
        const HostPicture::Language plain{};
        const Judged without = host.judge(light, plain, {});
        EXPECT_GT(without.beyond, 100u) << "nothing, or whole triangles";
        EXPECT_EQ(host.judge(light).beyond, 0u);
        MaskAlpha alpha = slanted({.texels = texels}).alpha;
        const auto state = [&] { return host.masks.casterState(); };
        const auto before = state();
        host.masks.setAlpha(host.ids.front(), alpha);
        EXPECT_EQ(state(), before) << "nothing has changed";
        alpha.cutoff = 0.25f;
        host.masks.setAlpha(host.ids.front(), alpha);
        EXPECT_NE(state(), before);
        const auto changed = state();
        host.masks.move(host.ids.front(), numbersOf(glm::translate(glm::dmat4(1.0), {1, 0, 0})));
        EXPECT_NE(state(), changed);
        const auto moved = state();
        host.masks.remove(host.ids.front());
        EXPECT_NE(state(), moved);
    }
}

TEST(CutoutLookup, RefusesTexelsThatAreWrong) {
    Host host({slanted({.texels = blobs(2, 2, 1)})});
    const auto wrong = [&](int width, int height, std::size_t count) -> std::string {
        auto texels = std::make_shared<MaskTexels>();
        texels->width = width;
        texels->height = height;
        texels->alpha.resize(count);
        try {
            host.masks.setAlpha(host.ids.front(), {.cutsOut = true, .texels = texels});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(wrong(0, 2, 0), "An alpha has 0x2 texels, not 1 to 16777216.");
    EXPECT_EQ(wrong(-1, -1, 1), "An alpha has -1x-1 texels, not 1 to 16777216.");
    EXPECT_EQ(wrong(8192, 8192, 0), "An alpha has 8192x8192 texels, not 1 to 16777216.");
    EXPECT_EQ(wrong(3, 2, 5), "An alpha of 3x2 texels has 5 numbers.");
    EXPECT_EQ(wrong(3, 2, 6), "none");
}

} // namespace edgeshade
