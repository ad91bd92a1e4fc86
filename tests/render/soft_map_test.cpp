// Percentage-closer soft shadows against known penumbras: their width, their absence, and what
// stays dark.

#include "src/shadow/view/frustum.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <ostream>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;

constexpr int width = 240, height = 180;

RenderSettings soft(SoftShadows how = SoftShadows::pcss, bool facesApart = false) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::map;
    settings.map.size = 1024;
    settings.map.soft = how;
    settings.map.facesApart = facesApart;
    return settings;
}

Light lamp(const glm::dvec3& position, double radius) {
    Light light = pointLight(position);
    light.extent = LightExtent{.shape = LightExtent::Shape::sphere, .radius = radius};
    return light;
}

Light disc(const glm::dvec3& towards, double radius) {
    Light light = sun(towards);
    light.extent = LightExtent{.shape = LightExtent::Shape::disc, .radius = radius};
    return light;
}

Light panel(const glm::dvec3& position, const glm::dvec2& size, const glm::dvec3& direction) {
    Light light = pointLight(position);
    light.extent = LightExtent{.shape = LightExtent::Shape::rectangle,
                               .size = size,
                               .direction = glm::normalize(direction)};
    return light;
}

/// A mask that is queried by places in the world.
class Mask {
  public:
    Mask(const Scene& scene, const Camera& camera, const Light& light,
         const RenderSettings& settings)
        : view_{camera, {light}, width, height, true},
          pixels_(test::drawScene(scene, view_, settings)) {}

    /// The share of the light, 0..1, at the pixel that shows a point.
    double at(const glm::dvec3& point) const {
        const Frustum frustum = view_.seen();
        const glm::dvec4 clip =
            clipFromView(frustum, 0.1, 1e3) * frustum.viewFromWorld * glm::dvec4(point, 1.0);
        const auto x = static_cast<int>((0.5 + 0.5 * clip.x / clip.w) * width);
        const auto y = static_cast<int>((0.5 - 0.5 * clip.y / clip.w) * height);
        if (x < 0 || x >= width || y < 0 || y >= height) {
            ADD_FAILURE() << "the point is not in the picture";
            return -1.0;
        }
        return pixels_[4 * static_cast<std::size_t>(y * width + x)] / 255.0;
    }

    /// Number of visible pixels with neither of these values.
    int neither(std::uint8_t one, std::uint8_t other) const {
        int count = 0;
        for (std::size_t i = 0; i < pixels_.size(); i += 4)
            count += pixels_[i + 3] != 0 && pixels_[i] != one && pixels_[i] != other;
        return count;
    }
    const std::vector<std::uint8_t>& pixels() const { return pixels_; }

  private:
    test::TestView view_;
    std::vector<std::uint8_t> pixels_;
};

/// A floor, and above it a quad with an edge at x = 0, seen from below the quad.
Scene edgeOverFloor() {
    return SceneBuilder().floor(6).quad({-4, 1, 4}, {0, 1, 4}, {0, 1, -4}, {-4, 1, -4}).scene();
}
const Camera below{{0.05, 0.9, 0.05}, {0.05, 0, 0}, 40.0};

/// The share of a disc of radius 1 beyond a line at u from its middle.
double shareOfDisc(double u) {
    u = std::clamp(u, -1.0, 1.0);
    return 0.5 + (u * std::sqrt(1.0 - u * u) + std::asin(u)) / std::numbers::pi;
}
double shareOfSquare(double u) {
    return 0.5 + 0.5 * std::clamp(u, -1.0, 1.0);
}

struct Penumbra {
    const char* name;
    Light light;
    double halfWidth;
    double (*share)(double);
    bool facesApart = false;

    friend void PrintTo(const Penumbra& of, std::ostream* stream) { *stream << of.name; }
};

class Penumbras : public testing::TestWithParam<Penumbra> {};

TEST_P(Penumbras, OfAnEdgeAreAsWideAsTheLightSeenPastIt) {
    const Penumbra& of = GetParam();
    const Mask mask(edgeOverFloor(), below, of.light, soft(SoftShadows::pcss, of.facesApart));
    double wrong = 0.0, most = 0.0;
    constexpr int places = 60;
    for (int i = 0; i <= places; ++i) {
        const double u = -1.5 + 3.0 * i / places;
        const double error = mask.at({u * of.halfWidth, 0, 0}) - of.share(u);
        wrong += std::abs(error) / (places + 1);
        most = std::max(most, std::abs(error));
    }
    std::printf("%s: %.3f on average, %.3f at most\n", of.name, wrong, most);
    EXPECT_LT(wrong, 0.04);
    EXPECT_LT(most, 0.25); // where few of the search's taps hit the caster
    EXPECT_EQ(mask.at({-1.8 * of.halfWidth, 0, 0}), 0.0);
    EXPECT_EQ(mask.at({1.8 * of.halfWidth, 0, 0}), 1.0);
}

// A lamp of radius r, d above a caster that is 1 above the floor: the penumbra is r / d to either
// side.
INSTANTIATE_TEST_SUITE_P(
    , Penumbras,
    testing::Values(Penumbra{"lamp", lamp({0, 5, 0}, 0.4), 0.1, shareOfDisc},
                    Penumbra{"lampWithFacesApart", lamp({0, 5, 0}, 0.4), 0.1, shareOfDisc, true},
                    Penumbra{"largeLamp", lamp({0, 5, 0}, 0.8), 0.2, shareOfDisc},
                    Penumbra{"nearLamp", lamp({0, 2.5, 0}, 0.15), 0.1, shareOfDisc},
                    Penumbra{"panel", panel({0, 5, 0}, {0.8, 0.3}, {0, -1, 0}), 0.1, shareOfSquare},
                    Penumbra{"sun", disc({0, 1, 0}, std::atan(0.1)), 0.1, shareOfDisc},
                    Penumbra{"largeSun", disc({0, 1, 0}, std::atan(0.2)), 0.2, shareOfDisc}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// A box that stands on the floor, in light from its right.
Scene boxOnFloor() {
    return SceneBuilder().floor(6).box({-1, 0, -1}, {1, 1, 1}).scene();
}
const Camera above{{0, 9, 0.01}, {0, 0, 0}, 45.0};
const Light fromTheRight[] = {lamp({6, 6, 0}, 0.5), panel({6, 6, 0}, {0.8, 0.8}, {-1, -1, 0}),
                              disc({1, 1, 0}, 0.08)};

TEST(SoftMap, ContactStaysDarkOnOneSideAndLitOnTheOther) {
    for (const Light& light : fromTheRight) {
        const Mask mask(boxOnFloor(), above, light, soft());
        for (const double z : {-0.5, 0.0, 0.5}) {
            EXPECT_EQ(mask.at({-1.3, 0, z}), 0.0);
            EXPECT_GT(mask.at({1.12, 0, z}), 0.9);
            EXPECT_EQ(mask.at({1.3, 0, z}), 1.0);
            EXPECT_EQ(mask.at({0.5, 1, z}), 1.0); // the box's top
        }
    }
}

TEST(SoftMap, NothingIsLitWhereAllOfTheLightIsHidden) {
    const Scene closed = SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1}).scene();
    const Mask outside(closed, {{6, 9, 8}, {0, 1, 0}, 45.0}, lamp({0.3, 3, 0.2}, 0.4), soft());
    EXPECT_EQ(outside.neither(0, 0), 0);
    const Scene roofed = SceneBuilder().floor(6).box({-3, 1, -3}, {3, 1.1f, 3}).scene();
    for (const Light& light : {lamp({0, 6, 0}, 0.5), disc({0.1, 1, 0.05}, 0.1)}) {
        const Mask under(roofed, below, light, soft());
        EXPECT_EQ(under.neither(0, 0), 0);
    }
}

// Wide filters sample along the receiver's plane; otherwise most of that plane would shade itself.
TEST(SoftMap, SurfacesDontShadeThemselves) {
    const Scene floor = SceneBuilder().floor(6).scene();
    for (const Light& light :
         {lamp({7, 3, 1}, 0.8), panel({7, 3, 1}, {2, 1}, {-1, -0.4, 0}), disc({1, 0.3, 0.2}, 0.1)})
        EXPECT_EQ(Mask(floor, {{0, 9, 6}, {0, 0, 0}, 45.0}, light, soft()).neither(255, 255), 0);
}

TEST(SoftMap, APanelLightsNothingBehindIt) {
    const Scene floor = SceneBuilder().floor(6).scene();
    const Mask mask(floor, above, panel({0, 2, 0}, {1, 1}, {1, 0, 0}), soft());
    EXPECT_EQ(mask.at({-0.5, 0, 0}), 0.0);
    EXPECT_EQ(mask.at({0.5, 0, 0}), 1.0);
}

TEST(SoftMap, FacesApartLookTheSame) {
    const Scene scene = test::yard().scene();
    const Camera camera{{5, 4, 6}, {0, 0.5, 0}, 70.0};
    const Light light = lamp({0.3, 1.2, 0.7}, 0.3);
    const Mask whole(scene, camera, light, soft()),
        apart(scene, camera, light, soft(SoftShadows::pcss, true));
    std::size_t different = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); i += 4)
        different += std::abs(whole.pixels()[i] - apart.pixels()[i]) > 8;
    // Rounding may put taps into neighbouring texels.
    EXPECT_LE(different, whole.pixels().size() / 4 / 100);
}

TEST(SoftMap, LightsWithoutAnExtentStayHard) {
    for (const Light& light : {pointLight({6, 6, 0}), sun({1, 1, 0})}) {
        const Mask hard(boxOnFloor(), above, light, soft(SoftShadows::none));
        const Mask other(boxOnFloor(), above, light, soft());
        EXPECT_EQ(hard.pixels(), other.pixels());
        EXPECT_EQ(hard.neither(0, 255), 0);
    }
    EXPECT_GT(Mask(boxOnFloor(), above, fromTheRight[0], soft()).neither(0, 255), 100);
}

// With a filter of constant width the mask is grey too, but as wide at the foot of a wall as far
// away.
TEST(SoftMap, PlainFiltersAreAsWideEverywhere) {
    RenderSettings settings = soft(SoftShadows::pcf);
    settings.map.pcf = 7;
    EXPECT_GT(Mask(boxOnFloor(), above, fromTheRight[0], settings).neither(0, 255), 50);
    settings.map.pcf = 1;
    EXPECT_EQ(Mask(boxOnFloor(), above, fromTheRight[0], settings).neither(0, 255), 0);
}

} // namespace
} // namespace edgeshade
