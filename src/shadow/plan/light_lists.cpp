#include "src/shadow/plan/light_lists.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// The tiles that a rectangle of pixels touches.
PixelRectangle tilesOf(const PixelRectangle& pixels) {
    if (pixels.empty()) return {};
    constexpr int tile = LightLists::tile;
    const int x = pixels.x / tile, y = pixels.y / tile;
    return {x, y, (pixels.x + pixels.width - 1) / tile - x + 1,
            (pixels.y + pixels.height - 1) / tile - y + 1};
}

/// Calls use(tile's index, light's index in `lights`), light by light.
template <class Use>
void forEachEntry(std::span<const ReachingLight> lights, int columns, Use use) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const PixelRectangle tiles = tilesOf(lights[i].reach);
        for (int y = tiles.y; y < tiles.y + tiles.height; ++y)
            for (int x = tiles.x; x < tiles.x + tiles.width; ++x)
                use(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(x),
                    static_cast<std::uint32_t>(i));
    }
}

} // namespace

LightLists listLights(std::span<const ReachingLight> lights, int width, int height) {
    LightLists lists;
    const PixelRectangle tiles = tilesOf({0, 0, width, height});
    lists.columns = tiles.width;
    lists.ofTile.resize(static_cast<std::size_t>(tiles.width) *
                        static_cast<std::size_t>(tiles.height));
    for (const ReachingLight& of : lights) {
        lists.lights.push_back(of.light);
        lists.reach = united(lists.reach, of.reach);
    }
    forEachEntry(lights, lists.columns,
                 [&](std::size_t tile, std::uint32_t) { ++lists.ofTile[tile].count; });
    std::uint32_t end = 0;
    for (LightLists::Range& range : lists.ofTile) {
        range.first = end;
        end += range.count;
        lists.longest = std::max<std::size_t>(lists.longest, range.count);
        range.count = 0;
    }
    lists.entries.resize(end);
    forEachEntry(lights, lists.columns, [&](std::size_t tile, std::uint32_t light) {
        LightLists::Range& range = lists.ofTile[tile];
        lists.entries[range.first + range.count++] = light;
    });
    return lists;
}

} // namespace edgeshade
