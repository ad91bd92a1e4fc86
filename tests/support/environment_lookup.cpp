#include "tests/support/environment_lookup.hpp"

#include <algorithm>

namespace edgeshade::test {
namespace {

/// The GL's linear filtering between texels: each channel by itself, 0 to 1. `texel` counts from
/// the first texel's corner and is at least 1/2 away from the atlas' edges.
glm::vec4 filtered(const Atlas& atlas, const glm::vec2& texel) {
    const glm::vec2 from = texel - 0.5f;
    const glm::ivec2 first(from);
    const glm::vec2 share = from - glm::vec2(first);
    const auto stored = [&](int x, int y) {
        const std::uint8_t* bytes =
            atlas.rgba().data() + 4 * ((first.y + y) * Atlas::width() + first.x + x);
        return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
    };
    return glm::mix(glm::mix(stored(0, 0), stored(1, 0), share.x),
                    glm::mix(stored(0, 1), stored(1, 1), share.x), share.y);
}

glm::vec3 levelRadiance(const Atlas& atlas, const glm::vec2& at, int level) {
    const AtlasTile tile = Atlas::tile(level);
    const auto mapSize = static_cast<float>(Atlas::mapSize(level));
    return decodeRadiance(
        filtered(atlas, glm::vec2(tile.x, tile.y) + 1.0f + (at * 0.5f + 0.5f) * mapSize),
        atlas.largestRoot());
}

} // namespace

glm::vec3 decodeRadiance(const glm::vec4& stored, float largestRoot) {
    const glm::vec3 root = glm::vec3(stored) * (stored.a * largestRoot);
    return root * root;
}

glm::vec3 environmentDiffuse(const Environment& environment, const glm::vec3& normal) {
    const std::array<float, 9> terms = diffuseTerms(normal);
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < terms.size(); ++i)
        sum += environment.diffuse[i] * terms[i];
    return glm::max(sum, 0.0f);
}

glm::vec3 environmentSpecular(const Environment& environment, const glm::vec3& direction,
                              float roughness) {
    const glm::vec2 at = octahedralFromDirection(direction);
    const int last = Atlas::levels() - 1;
    const float level = std::clamp(roughness, 0.0f, 1.0f) * static_cast<float>(last);
    const int lower = std::min(static_cast<int>(level), last - 1);
    return glm::mix(levelRadiance(environment.specular, at, lower),
                    levelRadiance(environment.specular, at, lower + 1),
                    level - static_cast<float>(lower));
}

} // namespace edgeshade::test
