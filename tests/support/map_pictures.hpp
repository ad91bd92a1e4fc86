#pragma once

#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

namespace edgeshade::test {

inline constexpr int mapWidth = 160, mapHeight = 120;

inline RenderSettings maps(MapKind kind, MapFilter filter = MapFilter::compare, int pcf = 1,
                           int size = 512, WarpGrid warp = WarpGrid::rectilinear) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::map;
    settings.map = {{.size = size, .kind = kind, .filter = filter, .pcf = pcf, .warp = warp}};
    if (filter == MapFilter::variance || filter == MapFilter::moments)
        settings.map.biasTexels = 0.5f;
    return settings;
}

std::vector<std::uint8_t> drawMask(const Scene& scene, const Camera& camera, const Light& light,
                                   const RenderSettings& settings);

/// Percentage of visible pixels that differ from ray casting.
double wrongIn(const Scene& scene, const Camera& camera, const Light& light,
               const RenderSettings& settings);

int darkPixels(const std::vector<std::uint8_t>& mask);

/// The largest share of the light that reaches a pixel in shadow on a surface that faces the light,
/// if all pixels within `aside` of it are in shadow too.
double leakIn(const Scene& scene, const Camera& camera, const Light& light,
              const RenderSettings& settings, int aside = 8);

/// Pixels in half shadow: between a fifth and four fifths of the light.
int greyPixels(const Scene& scene, const Camera& camera, const Light& light,
               const RenderSettings& settings);

} // namespace edgeshade::test
