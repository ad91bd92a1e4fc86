#include "src/environment/atlas.hpp"

#include "shaders_es2/environment_layout.glsl"
#include "src/environment/radiance_encoding.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr auto atlasWidth = static_cast<int>(ENVIRONMENT_WIDTH);
constexpr auto atlasHeight = static_cast<int>(ENVIRONMENT_HEIGHT);
constexpr auto mirrorTile = static_cast<int>(ENVIRONMENT_MIRROR_TILE);
constexpr auto glossyTile = static_cast<int>(ENVIRONMENT_GLOSSY_TILE);
constexpr auto roughTile = static_cast<int>(ENVIRONMENT_ROUGH_TILE);
constexpr auto lastLevel = static_cast<int>(ENVIRONMENT_LAST_LEVEL);

std::size_t offsetOf(int x, int y) {
    return std::size_t{4} * static_cast<std::size_t>(y * atlasWidth + x);
}

} // namespace

Atlas::Atlas(float largest)
    : largestRoot_(std::sqrt(std::min(largest, largestEncodedRadiance))),
      rgba_(offsetOf(0, atlasHeight), 0) {}

int Atlas::width() {
    return atlasWidth;
}

int Atlas::height() {
    return atlasHeight;
}

int Atlas::levels() {
    return lastLevel + 1;
}

float Atlas::roughness(int level) {
    return static_cast<float>(level) / static_cast<float>(lastLevel);
}

AtlasTile Atlas::tile(int level) {
    if (level == 0) return {0, 0, mirrorTile};
    if (level < 3) return {mirrorTile + glossyTile * (level - 1), 0, glossyTile};
    return {mirrorTile + roughTile * (level - 3), glossyTile, roughTile};
}

void Atlas::setLevel(int level, const OctahedralMap& map) {
    const AtlasTile place = tile(level);
    for (int y = 0; y < place.size; ++y)
        for (int x = 0; x < place.size; ++x) {
            const auto texel = encodeRadiance(map.at(x - 1, y - 1), largestRoot_);
            std::copy(texel.begin(), texel.end(),
                      rgba_.data() + offsetOf(place.x + x, place.y + y));
        }
}

} // namespace edgeshade
