// Shadows whose outline is known from geometry.

#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;

constexpr int size = 256;

/// A camera straight above that sees the floor from -half to half, so that the map from pixels to
/// the floor is linear.
Camera above(double height, double half) {
    return {{0, height, 0}, {0, 0, 0}, glm::degrees(2.0 * std::atan(half / height))};
}

std::vector<std::uint8_t> maskOf(const SceneBuilder& builder, const Camera& camera,
                                 const Light& light) {
    return test::drawScene(builder.scene(), {camera, {light}, size, size, true}, {});
}

/// The first pixels where two masks differ, "" if none do.
std::string differences(const std::vector<std::uint8_t>& mask,
                        const std::vector<std::uint8_t>& expected) {
    std::string places;
    for (int i = 0; i < size * size && places.size() < 200; ++i)
        if (mask[4 * static_cast<std::size_t>(i)] != expected[4 * static_cast<std::size_t>(i)])
            places += "(" + std::to_string(i % size) + ", " + std::to_string(i / size) + ") ";
    return places;
}

/// Floor coordinates of a pixel's centre under above(): x to the right, z down the picture.
glm::dvec2 floorPoint(int x, int y, double half) {
    return {half * (2.0 * (x + 0.5) / size - 1.0), half * (2.0 * (y + 0.5) / size - 1.0)};
}

struct Rectangle {
    double x0, z0, x1, z1;
    /// Distance inside (positive) or outside (negative).
    double depth(const glm::dvec2& p) const {
        return std::min({p.x - x0, x1 - p.x, p.y - z0, z1 - p.y});
    }
};

/// Every floor pixel must be black in `shadow` and white outside. Pixels of `hidden` show the
/// caster, and boundaries may go either way within half a pixel.
void expectFloorShadow(const std::vector<std::uint8_t>& mask, double half, const Rectangle& shadow,
                       const Rectangle& hidden) {
    const double tolerance = 0.75 * 2.0 * half / size;
    int checked = 0, wrong = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 p = floorPoint(x, y, half);
            if (hidden.depth(p) > -tolerance || std::abs(shadow.depth(p)) < tolerance) continue;
            const std::uint8_t* pixel = &mask[4 * (static_cast<std::size_t>(y) * size + x)];
            ++checked;
            wrong += pixel[3] != 255 || (pixel[0] == 0) != (shadow.depth(p) > 0.0);
        }
    EXPECT_GT(checked, size * size / 2);
    EXPECT_EQ(wrong, 0);
}

// Point light at (0, 8, 0); box from height 2 to 4 over x, z in [-1, 1]. Its top (height 4) is
// projected from 8 to the floor with factor 8 / (8 - 4) = 2: the shadow is [-2, 2] squared. The eye
// at height 20 sees the box's top as 20 / (20 - 4) = 1.25 wide on the floor: hidden.
TEST(KnownShadows, BoxOverFloorUnderPointLight) {
    const auto scene = SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1});
    const auto mask = maskOf(scene, above(20, 5), pointLight({0, 8, 0}));
    expectFloorShadow(mask, 5, {-2, -2, 2, 2}, {-1.25, -1.25, 1.25, 1.25});
}

// The same with the light moved to (2, 8, 0). A corner at (x, h) lands at 2 + (x - 2) * 8/(8-h):
// top x -1 -> 2 - 6 = -4, 1 -> 0; bottom (factor 4/3) -1 -> -2, 1 -> 2/3. Side walls join top and
// bottom, so in x the shadow runs from -4 to 2/3; in z the top's 2 counts only where x <= 0, so the
// rows |z| < 4/3 are checked.
TEST(KnownShadows, BoxOverFloorUnderSidewaysPointLight) {
    const auto scene = SceneBuilder().floor(8).box({-1, 2, -1}, {1, 4, 1});
    const auto mask = maskOf(scene, above(20, 5), pointLight({2, 8, 0}));
    const double pixel = 10.0 / size;
    for (int x = 0; x < size; ++x) {
        const glm::dvec2 p = floorPoint(x, size / 2, 5);
        if (std::abs(p.x) < 1.25 + pixel || std::abs(p.x + 4.0) < pixel ||
            std::abs(p.x - 2.0 / 3.0) < pixel)
            continue;
        const bool dark = mask[4 * (size / 2 * size + x)] == 0;
        EXPECT_EQ(dark, p.x > -4.0 && p.x < 2.0 / 3.0) << "at x = " << p.x;
    }
}

// A directional light towards (1, 1, 0) moves a point at height h by -h in x: the box from height 2
// to 4 shades x from -1 - 4 to 1 - 2, z from -1 to 1.
TEST(KnownShadows, BoxOverFloorUnderSun) {
    const auto scene = SceneBuilder().floor(8).box({-1, 2, -1}, {1, 4, 1});
    const auto mask = maskOf(scene, above(40, 7), sun({1, 1, 0}));
    const double factor = 40.0 / 36.0;
    expectFloorShadow(mask, 7, {-5, -1, -1, 1}, {-factor, -factor, factor, factor});
}

TEST(KnownShadows, SunsLengthDoesNotMatter) {
    const auto scene = SceneBuilder().floor(8).box({-1, 2, -1}, {1, 4, 1});
    const auto expected = maskOf(scene, above(40, 7), sun({1, 1, 0}));
    for (const double length : {1.0, 1e-30, 1e30})
        EXPECT_EQ(differences(maskOf(scene, above(40, 7), sun({length, length, 0})), expected), "")
            << length;
}

// A light inside a closed box reaches nothing outside.
TEST(KnownShadows, LightInsideAClosedBoxLightsNothingOutside) {
    const auto scene = SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1});
    const auto mask = maskOf(scene, {{6, 9, 8}, {0, 1, 0}, 45.0}, pointLight({0.3, 3, 0.2}));
    int visible = 0, lit = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4) {
        visible += mask[i + 3] != 0;
        lit += mask[i] != 0;
    }
    EXPECT_GT(visible, size * size / 4);
    EXPECT_EQ(lit, 0);
}

TEST(KnownShadows, LightAndEyeInsideAClosedBoxSeeItAllLit) {
    const auto scene = SceneBuilder().box({-1, -1, -1}, {1, 1, 1});
    const auto mask = maskOf(scene, {{0.5, 0.4, 0.6}, {-1, -1, -1}, 90.0}, pointLight({0, 0.2, 0}));
    for (std::size_t i = 0; i < mask.size(); i += 4)
        ASSERT_EQ(mask[i], 255);
}

// An open sheet is lit on the light's side and dark on the other, for either winding.
TEST(KnownShadows, OpenSheetIsLitOnOneSideAlone) {
    const glm::vec3 a(-1, 0, 1), b(1, 0, 1), c(1, 0, -1), d(-1, 0, -1);
    for (const auto& sheet : {SceneBuilder().quad(a, b, c, d), SceneBuilder().quad(d, c, b, a)}) {
        const auto top = maskOf(sheet, above(5, 0.9), pointLight({0.2, 3, 0.1}));
        const auto bottom = maskOf(sheet, {{0, -5, 0}, {0, 0, 0}, 20.0}, pointLight({0.2, 3, 0.1}));
        for (std::size_t i = 0; i < top.size(); i += 4) {
            ASSERT_EQ(top[i], 255);
            ASSERT_EQ(bottom[i], 0);
            ASSERT_EQ(bottom[i + 3], 255);
        }
    }
}

TEST(KnownShadows, NothingAtAllIsTransparent) {
    const auto mask = maskOf(SceneBuilder(), above(5, 1), pointLight({0, 3, 0}));
    EXPECT_EQ(mask, std::vector<std::uint8_t>(mask.size(), 0));
}

// More sheets in a row than a stencil can count, so that casters are split into groups, and the eye
// in a closed box, where everything visible is in shadow. A mask still shows the box, and so does a
// picture, with the pane in front.
TEST(KnownShadows, TheInsideOfABoxStaysInSightWhereCastersComeInGroups) {
    SceneBuilder builder;
    builder.box({-5, -5, -5}, {5, 5, 5});
    for (int i = 0; i < 300; ++i) {
        const float z = -20.0f - 0.1f * static_cast<float>(i);
        builder.quad({20, -3, z}, {26, -3, z}, {26, 3, z}, {20, 3, z});
    }
    Material pane;
    pane.alphaMode = AlphaMode::blend;
    pane.baseColorFactor = {1, 0, 0, 0.5f};
    builder.material(pane).quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
    test::TestView view{{{0, 0, 3}, {0, 0, 0}, 45.0}, {sun({0.01, 0.02, -1})}, size, size, true};
    const auto mask = test::drawScene(builder.scene(), view, {});
    int seen = 0, lit = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4) {
        seen += mask[i + 3] == 255;
        lit += mask[i + 3] == 255 && mask[i] != 0;
    }
    EXPECT_EQ(seen, size * size);
    EXPECT_EQ(lit, 0);
    view.mask = false;
    const auto picture = test::drawScene(builder.scene(), view, {});
    const std::uint8_t* middle = &picture[4 * (size / 2 * size + size / 2)];
    EXPECT_GT(middle[0], middle[1]) << "the pane is red";
}

} // namespace
} // namespace edgeshade
