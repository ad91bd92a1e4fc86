#include "tests/support/map_pictures.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// The share of the light at each pixel, 0..1: the picture over the one without shadows; -1 where
/// the light is too weak.
std::vector<double> lightShares(const Scene& scene, const Camera& camera, const Light& light,
                                const RenderSettings& settings) {
    const TestView view{camera, {light}, mapWidth, mapHeight, false};
    RenderSettings none = settings, dark = settings;
    none.shadows = ShadowMethod::none;
    none.ambient = 0.0f;
    dark.ambient = 0.0f;
    const auto full = drawScene(scene, view, none), drawn = drawScene(scene, view, dark);
    std::vector<double> shares;
    for (std::size_t i = 0; i < full.size(); i += 4)
        shares.push_back(full[i] < 32 ? -1.0 : static_cast<double>(drawn[i]) / full[i]);
    return shares;
}

} // namespace

std::vector<std::uint8_t> drawMask(const Scene& scene, const Camera& camera, const Light& light,
                                   const RenderSettings& settings) {
    return drawScene(scene, {camera, {light}, mapWidth, mapHeight, true}, settings);
}

double wrongIn(const Scene& scene, const Camera& camera, const Light& light,
               const RenderSettings& settings) {
    const auto mask = drawMask(scene, camera, light, settings);
    const auto answers = castMask(scene, camera, light, mapWidth, mapHeight, 0.0);
    int visible = 0, wrong = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i] == Answer::nothing || mask[4 * i + 3] == 0) continue;
        ++visible;
        wrong += (mask[4 * i] != 0) != (answers[i] == Answer::lit);
    }
    EXPECT_GT(visible, mapWidth * mapHeight / 4);
    return 100.0 * wrong / visible;
}

int darkPixels(const std::vector<std::uint8_t>& mask) {
    int dark = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        dark += mask[i + 3] != 0 && mask[i] == 0;
    return dark;
}

double leakIn(const Scene& scene, const Camera& camera, const Light& light,
              const RenderSettings& settings, int aside) {
    const auto answers = castMask(scene, camera, light, mapWidth, mapHeight, 0.0);
    const auto shares = lightShares(scene, camera, light, settings);
    double leak = 0.0;
    int judged = 0;
    for (int y = aside; y < mapHeight - aside; ++y)
        for (int x = aside; x < mapWidth - aside; ++x) {
            bool dark = true;
            for (int j = y - aside; j <= y + aside && dark; ++j)
                for (int i = x - aside; i <= x + aside && dark; ++i)
                    dark = answers[static_cast<std::size_t>(j * mapWidth + i)] == Answer::shadow;
            const double share = shares[static_cast<std::size_t>(y * mapWidth + x)];
            if (!dark || share < 0.0) continue;
            ++judged;
            leak = std::max(leak, share);
        }
    EXPECT_GT(judged, 300);
    return leak;
}

int greyPixels(const Scene& scene, const Camera& camera, const Light& light,
               const RenderSettings& settings) {
    const auto shares = lightShares(scene, camera, light, settings);
    return static_cast<int>(std::count_if(shares.begin(), shares.end(),
                                          [](double share) { return share > 0.2 && share < 0.8; }));
}

} // namespace edgeshade::test
